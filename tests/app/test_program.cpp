#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>

#include "tests/app/program.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test_command_line::expect_error_lines;
using test_command_line::Outcome;
using test_command_line::run_executable;
using test_command_line::SmallRun;
using testing::HasSubstr;
using testing::MatchesRegex;

class Program : public SmallRun {
 protected:
  /// Runs the executable with standard output to the file.
  [[nodiscard]] Outcome run_into(const std::string& file, const std::string& arguments) const {
    const std::string command =
        fmt::format("SHAPEGAUGE_CACHE= {} {} > {} 2> {}", SHAPEGAUGE_EXECUTABLE, arguments, file, quoted("errors"));
    const int status = std::system(command.c_str());
    return {.status = WEXITSTATUS(status), .output = {}, .errors = test::text_of(at("errors"))};
  }
};

TEST_F(Program, HelpAndVersionGoToStandardOutput) {
  for (const std::string arguments : {"--help", "run --help", "sdf --help", "evaluate --help", "dataset --help",
                                      "dataset info --help", "dataset validate --help", "dataset generate --help"}) {
    const Outcome outcome = run_executable(arguments);
    EXPECT_EQ(outcome.status, 0) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("Example: shapegauge ")) << arguments;
    EXPECT_EQ(outcome.errors, "") << arguments;
  }
  EXPECT_THAT(run_executable("--version").output, MatchesRegex("shapegauge [0-9.]+ \\([0-9a-z-]+\\)\n"));
}

TEST_F(Program, ResultsThatDoNotReachAFullDeviceAreAnError) {
  test::write_text(at("d.csv"), "0,1,2,3\n1,0,3,2\n2,3,0,1\n3,2,1,0\n");
  test::write_text(at("c.cla"), "PSB 1\n2 4\na 0 2\n0\n1\nb 0 2\n2\n3\n");
  const std::string evaluate = " " + quoted("d.csv") + " --labels " + quoted("c.cla");
  for (const std::string& arguments : std::vector<std::string>{
           "--help", "--version", "measures", "info " + quoted("data/T0.off"), "dataset info " + quoted("data"),
           "dataset validate " + quoted("data"), "cache info --cache " + quoted("cache"), "evaluate" + evaluate,
           "compare" + evaluate + " " + quoted("d.csv"),
           "run " + quoted("small.json") + " --output " + quoted("out")}) {
    EXPECT_EQ(run_into("/dev/null", arguments).status, 0) << arguments;
    const Outcome outcome = run_into("/dev/full", arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_THAT(outcome.errors, HasSubstr("No space left on device")) << arguments;
  }
}

}  // namespace

}  // namespace shapegauge
