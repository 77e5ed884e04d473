#include "shapegauge/experiments/command_line/run_program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <new>

#include "shapegauge/core/version.h"
#include "shapegauge/experiments/command_line/dataset_command.h"
#include "shapegauge/experiments/command_line/evaluate_command.h"
#include "shapegauge/experiments/command_line/exit_status.h"
#include "shapegauge/experiments/command_line/run_command.h"
#include "shapegauge/experiments/command_line/sdf_command.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

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

int parse_and_run(CLI::App& app, std::span<const std::string> arguments) {
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
  int status = exit_success;
  add_run_command(app, status);
  add_sdf_command(app, status);
  add_evaluate_command(app, status);
  add_dataset_command(app, status);
  try {
    return std::max(parse_and_run(app, arguments), status);
  } catch (const Interrupted&) {
    return report("interrupted; no results were written", exit_interrupted);
  } catch (const std::bad_alloc&) {
    return report("out of memory", exit_unusable_input);
  } catch (const std::exception& error) {
    return report(error.what(), exit_unusable_input);
  }
}

}  // namespace shapegauge
