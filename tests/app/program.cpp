// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/support/small_dataset.h"

namespace shapegauge::test_command_line {

std::string executable_for_shell() {
  return std::regex_replace(std::string(SHAPEGAUGE_EXECUTABLE), std::regex(" "), "\\ ");
}

Outcome run_executable(const std::string& arguments) {
  const test::TemporaryFolder folder;
  const std::string output = (folder.path() / "output").string();
  const std::string errors = (folder.path() / "errors").string();
  const std::string command = "SHAPEGAUGE_CACHE='" + (folder.path() / "cache").string() + "' " +
                              executable_for_shell() + " </dev/null >'" + output + "' 2>'" + errors + "' " + arguments;
  const int status = std::system(command.c_str());
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .output = test::text_of(output),
          .errors = test::text_of(errors)};
}

Outcome succeeded(Outcome outcome, const char* file, int line) {
  EXPECT_EQ(outcome.status, 0) << file << ":" << line << ": " << outcome.errors;
  return outcome;
}

void expect_error_line(const Outcome& outcome, const std::string& words) {
  EXPECT_EQ(outcome.status, 2) << words;
  EXPECT_EQ(outcome.output, "") << words;
  EXPECT_THAT(outcome.errors, testing::MatchesRegex("shapegauge: error: [^\n]*\n"));
  EXPECT_THAT(outcome.errors, testing::HasSubstr(words));
}

void expect_error_lines(const std::vector<UnusableCall>& calls) {
  for (const auto& [arguments, words] : calls) {
    SCOPED_TRACE(arguments);
    expect_error_line(run_executable(arguments), words);
  }
}

namespace {

[[noreturn]] void become(std::vector<char*>& arguments, const std::filesystem::path& errors) {
  const int nothing = ::open("/dev/null", O_RDWR);
  const int file = ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

int exit_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status); }

}  // namespace

BackgroundRun::BackgroundRun(std::vector<std::string> arguments, const std::filesystem::path& errors,
                             const std::string& program) {
  std::string executable = program;
  std::vector<char*> pointers{executable.data()};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("cannot start a process");
  if (process_ == 0) become(pointers, errors);
}

BackgroundRun::~BackgroundRun() {
  if (has_ended()) return;
  ::kill(process_, SIGKILL);
  wait();
}

bool BackgroundRun::has_ended() {
  int status = 0;
  if (!ended_ && ::waitpid(process_, &status, WNOHANG) == process_) {
    ended_ = true;
    status_ = exit_of(status);
  }
  return ended_;
}

bool BackgroundRun::wait_until(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  while (!condition()) {
    if (has_ended() || std::chrono::steady_clock::now() > end) return condition();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

void BackgroundRun::send(int signal) const { ::kill(process_, signal); }

std::vector<pid_t> BackgroundRun::children() const {
  std::ifstream file("/proc/" + std::to_string(process_) + "/task/" + std::to_string(process_) + "/children");
  return {std::istream_iterator<pid_t>(file), {}};
}

int BackgroundRun::wait() {
  int status = 0;
  if (!ended_ && ::waitpid(process_, &status, 0) == process_) {
    ended_ = true;
    status_ = exit_of(status);
  }
  return status_;
}

Outcome CommandTest::run(std::string arguments) const {
  for (std::size_t i = arguments.find(" @"); i != std::string::npos; i = arguments.find(" @")) {
    arguments.replace(i + 1, 1, at("").string());
  }
  return run_executable(arguments);
}

void SmallRun::SetUp() {
  test::write_small_dataset(at("data"));
  test::write_text(at("small.json"), test::small_configuration("data").dump());
}

}  // namespace shapegauge::test_command_line
