// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/terminal.h"
#include "shapegauge/core/version.h"

namespace shapegauge {

namespace {

/// Rejects an empty value, such as that of an unset shell variable, which would pass for an option that is not given.
std::string empty_value_error(const std::string& value) { return value.empty() ? "must not be empty" : ""; }

/// Settings of all commands: no value is empty, options take one value each time they are given, which protects a
/// following file name, and program options may follow the command.
void settle(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() > 0) option->check(empty_value_error);
    if (!option->get_positional() && option->get_items_expected_max() > 1) option->allow_extra_args(false);
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->fallthrough();
    settle(*command);
  }
}

void add_program_options(CLI::App& app) {
  app.set_version_flag("-V,--version", fmt::format("shapegauge {} ({})", version(), commit()));
  const auto quiet = app.add_flag_callback(
      "-q,--quiet", [] { set_verbosity(Verbosity::quiet); }, "Print warnings and errors only");
  app.add_flag_callback(
         "-v,--verbose", [] { set_verbosity(Verbosity::verbose); }, "Also print the run time")
      ->excludes(quiet);
  app.require_subcommand(1);
  app.footer(
      "Example: shapegauge run configs/quickstart.json\n"
      "Help on a command: shapegauge help COMMAND\n"
      "Exit status: 0 success; 1 completed with reported failures; 2 unusable input or arguments, or results that "
      "could not be written; 3 a part did not pass 'check'; 130, 143, 129 interrupted (SIGINT, SIGTERM, SIGHUP).\n"
      "NO_COLOR=1 switches colours off.");
}

}  // namespace

void add_commands(CLI::App& app, int& status) {
  app.formatter(std::make_shared<HelpFormat>());
  app.set_help_flag("-h", "Print usage and the most important options");
  app.set_help_all_flag("--help", "Print all options");
  add_program_options(app);
  using Add = void (*)(CLI::App&, int&);
  const std::vector<std::pair<const char*, std::vector<Add>>> groups{
      {"Measure shapes",
       {add_sdf_command, add_check_command, add_normals_command, add_info_command, add_segment_command,
        add_view_command}},
      {"Search and compare shapes",
       {add_search_command, add_describe_command, add_distances_command, add_rerank_command}},
      {"Evaluate methods",
       {add_evaluate_command, add_compare_command, add_audit_command, add_leaderboard_command,
        add_segmentation_evaluation_command, add_measures_command}},
      {"Experiments", {add_run_command, add_cache_command}},
      {"Data and tools", {add_dataset_command, add_perturb_command, add_convert_command, add_completion_command}}};
  for (const auto& [heading, commands] : groups) {
    for (const Add add : commands) {
      add(app, status);
      app.get_subcommands([](const CLI::App*) { return true; }).back()->group(heading);
    }
  }
  settle(app);
}

}  // namespace shapegauge
