#include "tests/experiments/command_line/run_executable.h"

#include <cstdlib>
#include <sys/wait.h>

#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/text_files.h"

namespace shapegauge::test_command_line {

Outcome run_executable(const std::string& arguments) {
  const test_io::TemporaryFolder folder;
  const std::string output = (folder.path() / "output").string();
  const std::string errors = (folder.path() / "errors").string();
  const std::string command = "SHAPEGAUGE_CACHE='" + (folder.path() / "cache").string() + "' " +
                              std::string(SHAPEGAUGE_EXECUTABLE) + " " + arguments + " >'" + output + "' 2>'" + errors +
                              "' </dev/null";
  const int status = std::system(command.c_str());
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .output = test_experiments::text_of(output),
          .errors = test_experiments::text_of(errors)};
}

}  // namespace shapegauge::test_command_line
