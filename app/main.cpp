// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <malloc.h>
#include <new>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/commands.h"
#include "app/standard_streams.h"
#include "app/terminal.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

namespace {

/// Keeps freed memory for the next shape, since buffers of tens of megabytes are allocated for every one.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int large = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
#endif
}

/// Prints the error; returns the status.
int report(const std::string& message, int status) {
  print_error(message);
  return status;
}

/// Returns the full name of the innermost parsed command: "shapegauge dataset info".
std::string command_in(const CLI::App& app) {
  std::string command = app.get_name();
  for (const CLI::App* chosen : app.get_subcommands()) command += " " + command_in(*chosen);
  return command;
}

/// Returns the command that helps after unusable arguments: for a second file of `evaluate`, the one that takes
/// several.
std::string help_on(const CLI::ParseError& error, const std::string& command) {
  const bool has_extra_words = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) &&
                               std::string_view(error.what()).find(" -") == std::string_view::npos;
  return command == "shapegauge evaluate" && has_extra_words ? "shapegauge compare" : command + " --help";
}

/// Returns the long options of a command and of its parents.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* level = &app; level != nullptr; level = level->get_parent()) {
    for (const CLI::Option* option : level->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  return names;
}

const CLI::Option* find_option(const CLI::App& app, const std::string& name) {
  for (const CLI::App* level = &app; level != nullptr; level = level->get_parent()) {
    if (const CLI::Option* option = level->get_option_no_throw(name)) return option;
  }
  return nullptr;
}

std::string unknown_option(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : commands_of(app)) {
    if (command->get_option_no_throw(name) == nullptr) continue;
    return fmt::format("{} must follow the command, as in 'shapegauge {} {}'", name, command->get_name(), name);
  }
  const auto meant = nearest_word(name, option_names(app));
  return fmt::format("there is no option {}{}", name, meant ? fmt::format("; did you mean {}?", *meant) : "");
}

/// Returns an error for the first argument that is neither a command nor an option. CLI11 itself would report what is
/// missing, without suggestions.
std::optional<std::string> unknown_word(const CLI::App& program, std::span<const std::string> arguments) {
  const CLI::App* app = &program;
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
    const std::string& word = arguments[i];
    const bool is_option = word.size() > 1 && word[0] == '-' && !parse_number(word);
    if (is_option) {
      const bool is_long = word[1] == '-';
      const std::string name = is_long ? word.substr(0, word.find('=')) : word.substr(0, 2);
      const CLI::Option* option = find_option(*app, name);
      if (option == nullptr) return unknown_option(*app, name);
      const bool takes_next = option->get_items_expected_max() > 0 && name.size() == word.size();
      if (takes_next) ++i;
      continue;
    }
    const std::vector<const CLI::App*> commands = commands_of(*app);
    if (commands.empty()) continue;
    const auto found = std::ranges::find(commands, word, &CLI::App::get_name);
    if (found == commands.end()) {
      std::vector<std::string> names;
      for (const CLI::App* command : commands) names.push_back(command->get_name());
      return fmt::format("there is no command \"{}\"{}", word, suggestion(word, names));
    }
    app = *found;
  }
  return std::nullopt;
}

/// Converts "help run" to "run --help".
std::vector<std::string> without_help_command(std::span<const std::string> arguments) {
  std::vector<std::string> words(arguments.begin(), arguments.end());
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  if (words.empty() || words.back() != "--help") words.emplace_back("--help");
  return words;
}

/// Returns true if the arguments end where a command must follow.
bool lacks_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? !commands_of(app).empty() : lacks_command(*chosen.front());
}

int parse_and_run(CLI::App& app, std::span<const std::string> raw_arguments) {
  std::vector<std::string> arguments = without_help_command(raw_arguments);
  if (const auto unknown = unknown_word(app, arguments)) return report(*unknown, exit_unusable_input);
  std::ranges::reverse(arguments);  // the parser takes them from the back
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help and --version
      std::ostringstream text;
      app.exit(error, text, text);
      print_output("{}", text.str());
      return exit_success;
    }
    if (lacks_command(app)) {
      print_output("{}", app.help());
      return exit_unusable_input;
    }
    const std::string message = error.what();
    const bool suggests = message.ends_with('?');
    const std::string help = suggests ? "" : fmt::format("; see '{}'", help_on(error, command_in(app)));
    return report(message + help, exit_unusable_input);
  }
  return exit_success;
}

/// Runs the command of the arguments (without the program's name). Returns the exit status.
int run_command(std::span<const std::string> arguments) {
  CLI::App app("Shape diameter function, shape signatures and retrieval evaluation", "shapegauge");
  int status = exit_success;
  add_commands(app, status);
  const Stopwatch stopwatch;
  try {
    status = std::max(parse_and_run(app, arguments), status);
  } catch (const Interrupted& interruption) {
    return report(interruption.what(), interruption_status());
  } catch (const std::bad_alloc&) {
    return report("out of memory; use fewer threads (--threads), or a machine with more memory", exit_unusable_input);
  } catch (const std::filesystem::filesystem_error& error) {
    return report(fmt::format("cannot access {}: {}", error.path1().string(), error.code().message()),
                  exit_unusable_input);
  } catch (const std::exception& error) {
    return report(error.what(), exit_unusable_input);
  }
  if (verbosity() == Verbosity::verbose) {
    note(fmt::format("{} took {:.2f} s", command_in(app), stopwatch.seconds()));
  }
  return status;
}

/// Runs the program. Results go to standard output or files, messages and progress to standard error. A failure to
/// write standard output (a full disk) is an error; a closed pipe only sets the status.
int run_program(std::span<const std::string> arguments) {
  const int status = run_command(arguments);
  const int error = output_error();
  if (error == 0 || status == exit_unusable_input) return status;
  if (error == EPIPE) return exit_unusable_input;  // the reader needs no more, as `head`
  return report("cannot write to standard output: " + std::generic_category().message(error), exit_unusable_input);
}

}  // namespace

}  // namespace shapegauge

// NOLINTNEXTLINE(bugprone-exception-escape): only without memory for the arguments
int main(int argc, char** argv) {
  shapegauge::protect_standard_streams();
  shapegauge::keep_memory();
  // A limit of the size of files gives an error where the file is written, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);  // likewise a closed pipe
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return shapegauge::run_program(arguments);
}
