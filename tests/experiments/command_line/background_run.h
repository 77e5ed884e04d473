#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace shapegauge::test_command_line {

/// The built executable under way; it is killed, if need be, and waited for at the end of the scope.
class BackgroundRun {
 public:
  /// Starts it with the arguments, silent but for standard error, which goes to a file.
  BackgroundRun(std::vector<std::string> arguments, const std::filesystem::path& errors);
  BackgroundRun(const BackgroundRun&) = delete;
  BackgroundRun& operator=(const BackgroundRun&) = delete;
  BackgroundRun(BackgroundRun&&) = delete;
  BackgroundRun& operator=(BackgroundRun&&) = delete;
  ~BackgroundRun();

  /// Waits until the condition holds; false where the run ends, or a minute passes, before it does.
  bool wait_until(const std::function<bool()>& condition);
  void send(int signal) const;
  /// Waits for its end: the exit status, or minus the signal that ended it.
  int wait();

 private:
  bool has_ended();

  pid_t process_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

}  // namespace shapegauge::test_command_line
