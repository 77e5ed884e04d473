#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <malloc.h>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/configuration/nearest_word.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

namespace {

// A signal handler may touch lock-free atomics only, and has no other way to say something.
std::atomic<int> received_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void remember(int signal) {
  received_signal = signal;
  std::signal(signal, SIG_DFL);
}

/// Keeps freed memory for the next shape: structures of tens of megabytes come and go with every one.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int large = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
#endif
}

/// An error on one line, whatever the message.
int report(std::string message, int status) {
  std::ranges::replace(message, '\n', ' ');
  message.erase(message.find_last_not_of(' ') + 1);
  fmt::print(stderr, "shapegauge: error: {}\n", message);
  return status;
}

/// The full name of the innermost command that was parsed: "shapegauge dataset info".
std::string command_in(const CLI::App& app) {
  std::string command = app.get_name();
  for (const CLI::App* chosen : app.get_subcommands()) command += " " + command_in(*chosen);
  return command;
}

/// An error for a word in the place of a command that is none.
std::optional<std::string> unknown_command(const CLI::App& app, std::span<const std::string> arguments) {
  const std::vector<const CLI::App*> commands = app.get_subcommands([](const CLI::App*) { return true; });
  if (commands.empty() || arguments.empty() || arguments.front().starts_with('-')) return std::nullopt;
  std::vector<std::string> names;
  for (const CLI::App* command : commands) {
    if (command->get_name() == arguments.front()) return unknown_command(*command, arguments.subspan(1));
    names.push_back(command->get_name());
  }
  return fmt::format("there is no command \"{}\"{}", arguments.front(), suggestion(arguments.front(), names));
}

int parse_and_run(CLI::App& app, std::span<const std::string> arguments) {
  if (const auto unknown = unknown_command(app, arguments)) return report(*unknown, exit_unusable_input);
  // The parser takes its arguments from the back.
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version, on standard output
    return report(fmt::format("{}; see '{} --help'", error.what(), command_in(app)), exit_unusable_input);
  }
  return exit_success;
}

/// Does what the arguments (without the program's name) say. Returns the exit status.
int run_command(std::span<const std::string> arguments) {
  CLI::App app("Shape diameter function, shape signatures and retrieval evaluation", "shapegauge");
  app.set_version_flag("--version", fmt::format("shapegauge {} ({})", version(), commit()));
  app.require_subcommand(1);
  app.footer("Example: shapegauge run configs/quickstart.json");
  int status = exit_success;
  for (const auto add :
       {add_run_command, add_sdf_command, add_normals_command, add_info_command, add_perturb_command,
        add_evaluate_command, add_compare_command, add_measures_command, add_dataset_command, add_cache_command}) {
    add(app, status);
  }
  try {
    return std::max(parse_and_run(app, arguments), status);
  } catch (const Interrupted& interruption) {
    return report(interruption.what(), 128 + received_signal);
  } catch (const std::bad_alloc&) {
    return report("out of memory", exit_unusable_input);
  } catch (const std::exception& error) {
    return report(error.what(), exit_unusable_input);
  }
}

/// The program. Results go to standard output or files, messages and progress to standard error. Results that do not
/// reach standard output (a full disk, a closed pipe) are an error like any other.
int run_program(std::span<const std::string> arguments) {
  const int status = run_command(arguments);
  errno = 0;
  std::cout.flush();
  const bool written = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (written || status == exit_unusable_input) return status;
  const std::string reason = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  return report("cannot write to standard output" + reason, exit_unusable_input);
}

}  // namespace

void catch_interruption() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, remember);
  if (std::signal(SIGHUP, remember) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
}

bool interrupted() { return received_signal != 0; }

}  // namespace shapegauge

int main(int argc, char** argv) {
  shapegauge::keep_memory();
  // A limit of the size of files is met as a full disk is: by an error where the file is written.
  std::signal(SIGXFSZ, SIG_IGN);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return shapegauge::run_program(arguments);
}
