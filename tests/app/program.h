// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <sys/types.h>
#include <system_error>
#include <vector>

#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

/// Result of a call of the program.
struct Outcome {
  int status = 0;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Path of the built executable, for a shell, also within quotes of a further shell.
std::string executable_for_shell();

/// Runs the built executable with the arguments, as parsed by a shell, and waits for it. It has an empty cache of its
/// own unless the arguments name one.
Outcome run_executable(const std::string& arguments);

/// Returns the outcome; expects status 0, or else shows the line of the call and standard error. (Clang 14 has no
/// std::source_location.)
Outcome succeeded(Outcome outcome, const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// Expects an input error: status 2, one line on standard error that contains the words, and
/// nothing on standard output.
void expect_error_line(const Outcome& outcome, const std::string& words);

/// Invalid arguments, and words of the error expected.
struct UnusableCall {
  std::string arguments;
  std::string words;
};

/// Runs each call and expects an input error.
void expect_error_lines(const std::vector<UnusableCall>& calls);

/// Running instance of the built executable, killed if necessary at the end of the scope.
class BackgroundRun {
 public:
  /// Starts it with the arguments, with standard error written to a file; or, by its absolute path, the
  /// program that is to start it.
  BackgroundRun(std::vector<std::string> arguments, const std::filesystem::path& errors,
                const std::string& program = SHAPEGAUGE_EXECUTABLE);
  BackgroundRun(const BackgroundRun&) = delete;
  BackgroundRun& operator=(const BackgroundRun&) = delete;
  BackgroundRun(BackgroundRun&&) = delete;
  BackgroundRun& operator=(BackgroundRun&&) = delete;
  ~BackgroundRun();

  /// Waits until the condition holds; false if the run ends first, or after some minutes.
  bool wait_until(const std::function<bool()>& condition);
  void send(int signal) const;
  /// Its child processes.
  [[nodiscard]] std::vector<pid_t> children() const;
  /// Waits for its end: the exit status, or minus the signal that ended it.
  int wait();

 private:
  bool has_ended();

  pid_t process_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// Changes the working folder during its lifetime.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;
  WorkingFolder(WorkingFolder&&) = delete;
  WorkingFolder& operator=(WorkingFolder&&) = delete;
  ~WorkingFolder() {
    std::error_code ignored;
    std::filesystem::current_path(before_, ignored);
  }

 private:
  std::filesystem::path before_;
};

/// A folder for the files of calls.
class CommandTest : public test::FolderTest {
 protected:
  /// Quoted for a shell.
  [[nodiscard]] std::string quoted(const std::string& name) const { return "'" + at(name).string() + "'"; }
  /// Runs the built executable. Words that begin with @ are paths in the folder.
  [[nodiscard]] Outcome run(std::string arguments) const;
};

/// A folder with the small data set in data/, and with a configuration over it: small.json.
class SmallRun : public CommandTest {
 protected:
  void SetUp() override;
};

}  // namespace shapegauge::test_command_line
