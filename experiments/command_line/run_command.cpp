#include "shapegauge/experiments/command_line/run_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <memory>

#include "shapegauge/experiments/command_line/exit_status.h"
#include "shapegauge/experiments/command_line/interruption.h"
#include "shapegauge/experiments/command_line/progress_line.h"
#include "shapegauge/experiments/comparison/read_comparison.h"
#include "shapegauge/experiments/comparison/run_comparison.h"
#include "shapegauge/experiments/comparison/write_comparison.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/results/field_warnings.h"
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

/// Something that a run went on without.
struct LeftOut {
  std::string what;  ///< such as "model 12"
  std::string why;
};

/// Says on standard error what a reader of the results should know; returns the exit status. all: of how many shapes.
int report_flaws(const std::vector<FieldReport>& fields, const std::vector<LeftOut>& left_out, std::size_t all,
                 std::string_view kind) {
  for (const std::string& warning : field_warnings(fields)) fmt::print(stderr, "shapegauge: warning: {}\n", warning);
  for (const LeftOut& one : left_out) {
    fmt::print(stderr, "shapegauge: warning: left out {}: {}\n", one.what, one.why);
  }
  if (left_out.empty()) return exit_success;
  fmt::print(stderr, "shapegauge: error: {} of {} {} could not be used; the results are without them\n",
             left_out.size(), all, kind);
  return exit_with_failures;
}

/// The folder for the results of the experiment of that name, made ready.
fs::path result_folder(const RunArguments& arguments, const std::string& name, const nlohmann::json& configuration) {
  fs::path folder = arguments.output.empty() ? fs::path("results") / file_safe_name(name) : arguments.output;
  prepare_result_folder(folder, configuration, arguments.force);
  return folder;
}

RunControl run_control(const RunArguments& arguments, ProgressLine& progress) {
  catch_interruption();
  return {.threads = arguments.threads,
          .interrupted = interrupted,
          .progress = [&progress](std::string_view stage, std::size_t done, std::size_t total) {
            progress.show(stage, done, total);
          }};
}

int run_retrieval(const RunArguments& arguments, const Configuration& configuration) {
  const fs::path folder = result_folder(arguments, configuration.name, to_json(configuration));
  ProgressLine progress;
  const ExperimentResults results = run_experiment(configuration, folder / "dataset", run_control(arguments, progress));
  with_threads(arguments.threads, [&] { write_results(folder, results); });
  progress.clear();
  fmt::print("{}\nResults in {}\n", summary_text(results), folder.string());
  if (configuration.report.wanted) fmt::print("Report: {}\n", (folder / report_name).string());
  std::vector<LeftOut> left_out;
  for (const FailedModel& failure : results.failures)
    left_out.push_back({"model " + failure.model.id, failure.message});
  return report_flaws(results.fields, left_out, left_out.size() + results.models.size(), "models");
}

int run_shapes(const RunArguments& arguments, const Comparison& comparison) {
  const fs::path folder = result_folder(arguments, comparison.name, to_json(comparison));
  ProgressLine progress;
  const ComparisonResults results = run_comparison(comparison, run_control(arguments, progress));
  write_comparison(folder, results);
  progress.clear();
  fmt::print("{}\nResults in {}\n", summary_text(results), folder.string());
  std::vector<LeftOut> left_out;
  for (const FailedShape& failure : results.failures) {
    left_out.push_back({fmt::format("shape \"{}\"", failure.name), failure.message});
  }
  return report_flaws(results.fields, left_out, left_out.size() + results.shapes.size(), "shapes");
}

int run(const RunArguments& arguments) {
  const nlohmann::json document = read_configuration_document(arguments.configuration, arguments.overrides);
  const std::string source = arguments.configuration.string();
  const fs::path folder = arguments.configuration.parent_path();
  if (is_comparison(document)) return run_shapes(arguments, comparison_from_json(document, source, folder));
  return run_retrieval(arguments, configuration_from_json(document, source, folder));
}

}  // namespace

void add_run_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "Run an experiment from its configuration");
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
