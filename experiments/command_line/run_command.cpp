#include "shapegauge/experiments/command_line/run_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <memory>

#include "shapegauge/experiments/command_line/exit_status.h"
#include "shapegauge/experiments/command_line/interruption.h"
#include "shapegauge/experiments/command_line/progress_line.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/results/file_names.h"
#include "shapegauge/experiments/results/result_folder.h"
#include "shapegauge/experiments/results/write_results.h"
#include "shapegauge/experiments/runner/run_experiment.h"
#include "shapegauge/experiments/runner/with_threads.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
  fs::path configuration;
  fs::path output;
  int threads = 0;
  std::vector<std::string> overrides;
  bool force = false;
};

/// Says on standard error what a reader of the results should know; returns the exit status.
int report_flaws(const ExperimentResults& results) {
  for (const FieldReport& field : results.fields) {
    for (const char* outcome : {"undecided", "missing"}) {
      const auto count = field.outcomes.find(outcome);
      if (count == field.outcomes.end() || count->second == 0) continue;
      fmt::print(stderr, "shapegauge: warning: {} of {} samples {} in the field {}\n", count->second,
                 field.outcomes.at("total"), outcome, field.settings.dump());
    }
  }
  for (const FailedModel& failure : results.failures) {
    fmt::print(stderr, "shapegauge: warning: left out model {}: {}\n", failure.model.id, failure.message);
  }
  if (results.failures.empty()) return exit_success;
  fmt::print(stderr, "shapegauge: error: {} of {} models could not be used; the results are without them\n",
             results.failures.size(), results.failures.size() + results.models.size());
  return exit_with_failures;
}

int run(const RunArguments& arguments) {
  const Configuration configuration = read_configuration(arguments.configuration, arguments.overrides);
  const fs::path folder =
      arguments.output.empty() ? fs::path("results") / file_safe_name(configuration.name) : arguments.output;
  prepare_result_folder(folder, to_json(configuration), arguments.force);

  catch_interruption();
  ProgressLine progress;
  const RunControl control{.threads = arguments.threads,
                           .interrupted = interrupted,
                           .progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
                             progress.show(stage, done, total);
                           }};
  const ExperimentResults results = run_experiment(configuration, folder / "dataset", control);
  with_threads(arguments.threads, [&] { write_results(folder, results); });
  progress.clear();
  fmt::print("{}\nResults in {}\n", summary_text(results), folder.string());
  return report_flaws(results);
}

}  // namespace

void add_run_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "Run a retrieval experiment from its configuration");
  command->footer(
      "Example: shapegauge run configs/shrec11_table2.json --set signatures.0.histogram.bins=40\n"
      "A folder that holds the results of the same configuration is written anew; one with the results of another\n"
      "configuration only with --force.");
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("configuration", arguments->configuration, "Configuration file (JSON)")->required();
  command->add_option("--output", arguments->output, "Folder for the results (default: results/<name>)");
  command->add_option("--threads", arguments->threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
  command->add_option("--set", arguments->overrides, "Change a value of the configuration: dotted.key=value")
      ->allow_extra_args(false);
  command->add_flag("--force", arguments->force, "Replace the results of another configuration in the folder");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
