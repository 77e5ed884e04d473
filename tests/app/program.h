#pragma once

#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

/// What a call of the program gave.
struct Outcome {
  int status = 0;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs the built executable with the arguments, as a shell reads them, and waits for it. Its cache is empty and its
/// own, unless the arguments name another one.
Outcome run_executable(const std::string& arguments);

/// Expects what unusable input or arguments give: status 2, one line on standard error that holds the words, and
/// nothing on standard output.
void expect_error_line(const Outcome& outcome, const std::string& words);

/// The arguments of a call that are of no use, and words of its error.
struct UnusableCall {
  std::string arguments;
  std::string words;
};

/// Runs each and expects such an error line.
void expect_error_lines(const std::vector<UnusableCall>& calls);

/// The contents of a folder's result files by name, but for timings: those of the manifest are taken out.
std::map<std::string, std::string> results_in(const std::filesystem::path& folder);

/// The built executable under way; it is killed, if need be, and waited for at the end of the scope.
class BackgroundRun {
 public:
  /// Starts it with the arguments, silent but for standard error, which goes to a file; or, by its absolute path, the
  /// program that is to start it.
  BackgroundRun(std::vector<std::string> arguments, const std::filesystem::path& errors,
                const std::string& program = SHAPEGAUGE_EXECUTABLE);
  BackgroundRun(const BackgroundRun&) = delete;
  BackgroundRun& operator=(const BackgroundRun&) = delete;
  BackgroundRun(BackgroundRun&&) = delete;
  BackgroundRun& operator=(BackgroundRun&&) = delete;
  ~BackgroundRun();

  /// Waits until the condition holds; false where the run ends, or hangs for minutes, before it does.
  bool wait_until(const std::function<bool()>& condition);
  void send(int signal) const;
  /// The processes that it has started itself.
  [[nodiscard]] std::vector<pid_t> children() const;
  /// Waits for its end: the exit status, or minus the signal that ended it.
  int wait();

 private:
  bool has_ended();

  pid_t process_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// A folder with the small data set in data/, and with a configuration over it: small.json.
class SmallRun : public testing::Test {
 protected:
  void SetUp() override;
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  /// As a shell takes it.
  [[nodiscard]] std::string quoted(const std::string& name) const { return "'" + at(name).string() + "'"; }

 private:
  test::TemporaryFolder folder_;
};

}  // namespace shapegauge::test_command_line
