#include "app/run_program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <new>
#include <optional>

#include "app/cache_command.h"
#include "app/compare_command.h"
#include "app/dataset_command.h"
#include "app/evaluate_command.h"
#include "app/info_command.h"
#include "app/measures_command.h"
#include "app/normals_command.h"
#include "app/perturb_command.h"
#include "app/run_command.h"
#include "app/sdf_command.h"
#include "app/segment_command.h"
#include "app/segmentation_evaluation_command.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/configuration/nearest_word.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

namespace {

// A signal handler may touch lock-free atomics only, and has no other way to say something.
std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void remember(int signal) {
  was_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interruption() { std::signal(SIGINT, remember); }

bool interrupted() { return was_interrupted; }

namespace {

/// An error on one line, whatever the message.
int report(std::string message, int status) {
  std::ranges::replace(message, '\n', ' ');
  message.erase(message.find_last_not_of(' ') + 1);
  fmt::print(stderr, "shapegauge: error: {}\n", message);
  return status;
}

/// The command that the arguments had come to, for a pointer to its help.
std::string command_in(const CLI::App& app) {
  std::string command = app.get_name();
  for (const CLI::App* chosen : app.get_subcommands()) command += " " + command_in(*chosen);
  return command;
}

/// An error for a word that stands where a command should and is none; nothing where all is well so far.
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

}  // namespace

int run_program(std::span<const std::string> arguments) {
  CLI::App app("Shape diameter function, shape signatures and retrieval evaluation", "shapegauge");
  app.set_version_flag("--version", fmt::format("shapegauge {} ({})", version(), commit()));
  app.require_subcommand(1);
  app.footer("Example: shapegauge run configs/quickstart.json");
  // A limit of the size of files is met as a full disk is: by an error where the file is written.
  std::signal(SIGXFSZ, SIG_IGN);
  int status = exit_success;
  add_run_command(app, status);
  add_sdf_command(app, status);
  add_normals_command(app, status);
  add_segment_command(app, status);
  add_info_command(app, status);
  add_perturb_command(app, status);
  add_evaluate_command(app, status);
  add_compare_command(app, status);
  add_segmentation_evaluation_command(app, status);
  add_measures_command(app, status);
  add_dataset_command(app, status);
  add_cache_command(app, status);
  try {
    return std::max(parse_and_run(app, arguments), status);
  } catch (const Interrupted& interruption) {
    return report(interruption.what(), exit_interrupted);
  } catch (const std::bad_alloc&) {
    return report("out of memory", exit_unusable_input);
  } catch (const std::exception& error) {
    return report(error.what(), exit_unusable_input);
  }
}

}  // namespace shapegauge
