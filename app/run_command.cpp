// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/run_report.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/engine/part.h"
#include "shapegauge/experiments/engine/replay.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/kinds/experiment_kinds.h"
#include "shapegauge/experiments/results/evaluation_plots.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Source of a run: a configuration, or the manifest of a recorded run.
struct RunSource {
  fs::path configuration;
  std::vector<std::string> overrides;  ///< of the configuration, see apply_overrides()
  fs::path replay;                     ///< manifest of the run to repeat, instead of a configuration
  fs::path dataset_root;               ///< folder of the data set for a replay; if empty, the recorded one
};

/// Experiment to run: its configuration and its source.
// NOLINTNEXTLINE(bugprone-exception-escape): JSON moves without exceptions, which the check does not see
struct RequestedRun {
  nlohmann::json document;
  std::string source;           ///< name in messages
  fs::path folder;              ///< base of relative paths
  nlohmann::json recorded;      ///< manifest of the run to repeat; null for a new run
  std::vector<fs::path> files;  ///< files read: configuration or manifest, and descriptions of data sets
};

struct RunArguments {
  RunSource source;
  fs::path output;
  fs::path plot;
  std::string part;  ///< parse_part(); empty for the whole run
  int threads = 0;
  bool force = false;
  bool replace = false;
  bool print_configuration = false;
  bool dry_run = false;
  CacheOption cache;
};

/// Reads the requested run. Throws InputError if it cannot be read or is inconsistent.
RequestedRun requested_run(const RunSource& source) {
  if (!source.replay.empty()) {
    RequestedRun request;
    request.recorded = read_manifest(source.replay);
    request.document = recorded_configuration(request.recorded, source.dataset_root, experiment_paths);
    request.source = source.replay.string() + ": configuration";
    request.files =
        apply_overrides(request.document, request.source, request.folder, source.overrides, experiment_paths);
    request.files.push_back(source.replay);
    return request;
  }
  if (source.configuration.empty()) throw InputError("a configuration file is required; see 'shapegauge run --help'");
  if (!source.dataset_root.empty()) {
    throw InputError("--dataset-root requires --replay; for a configuration, use --set dataset.root=FOLDER");
  }
  RequestedRun request{.document = read_json(source.configuration),
                       .source = source.configuration.string(),
                       .folder = source.configuration.parent_path(),
                       .recorded = {},
                       .files = {}};
  request.files = apply_overrides(request.document, request.source, request.folder, source.overrides, experiment_paths);
  request.files.push_back(source.configuration);
  return request;
}

/// Throws InputError if the chart cannot be written.
void check_plot(const RunArguments& arguments) {
  if (arguments.plot.empty()) return;
  check_drawing_file(arguments.plot);
  const std::vector<fs::path> inputs{arguments.source.configuration, arguments.source.replay};
  const std::vector<OutputFile> outputs{{.path = arguments.plot, .what = "--plot"}};
  check_output_files(inputs, outputs, arguments.replace || arguments.force);
}

/// Warns of changed inputs before a repeated run starts.
void warn_of_inputs(const RequestedRun& request, const Experiment& experiment, int threads) {
  if (request.recorded.is_null() || !experiment.inputs) return;
  warn_of_changed_inputs(changed_inputs(request.recorded, experiment.inputs(threads)));
}

/// Prints the cache's warnings on destruction, however a run ends.
class CacheWarnings {
 public:
  CacheWarnings(const Cache& cache, ProgressLine& progress) : cache_(&cache), progress_(&progress) {}
  CacheWarnings(const CacheWarnings&) = delete;
  CacheWarnings& operator=(const CacheWarnings&) = delete;
  CacheWarnings(CacheWarnings&&) = delete;
  CacheWarnings& operator=(CacheWarnings&&) = delete;
  ~CacheWarnings() {
    const std::vector<std::string> warnings = cache_->warnings();
    if (!warnings.empty()) progress_->clear();
    for (const std::string& warning : warnings) warn(warning);
  }

 private:
  const Cache* cache_;
  ProgressLine* progress_;
};

/// Returns the result folder for an experiment's name; a replay does not overwrite the recorded results.
fs::path result_folder(const RunArguments& arguments, const std::string& name) {
  if (!arguments.output.empty()) return arguments.output;
  return fs::path("results") / (file_safe_name(name) + (arguments.source.replay.empty() ? "" : "-replay"));
}

/// Opens the requested cache. A replay does not read from it.
std::unique_ptr<Cache> cache_for(const RunArguments& arguments) {
  return std::make_unique<Cache>(requested_cache_folder(arguments.cache),
                                 arguments.force || !arguments.source.replay.empty());
}

RunControl run_control(const RunArguments& arguments, ProgressLine& progress) {
  catch_interruption();
  return {.threads = arguments.threads,
          .interrupted = interrupted,
          .progress = progress.receiver(),
          .bold = output_has_colours()};
}

/// Returns the message of an interrupted run.
std::string interruption_text(const Cache& cache) {
  return cache.folder().empty() ? "interrupted; no results were written"
                                : "interrupted; no results were written. Completed shapes are in the cache; the same "
                                  "command continues from there";
}

/// Calls the work with the cache and the control of a run.
template <typename Work>
auto with_cache(const RunArguments& arguments, ProgressLine& progress, const Work& work) {
  const std::unique_ptr<Cache> cache = cache_for(arguments);
  const CacheWarnings warnings(*cache, progress);
  try {
    return work(*cache, run_control(arguments, progress));
  } catch (const Interrupted&) {
    throw Interrupted(interruption_text(*cache));
  }
}

/// Prints the summary and remarks of a run; returns the exit status.
int report_run(const RunOutcome& outcome, const RunArguments& arguments, const RequestedRun& request,
               const fs::path& folder) {
  print_output("{}\n{}Results in {}\n", outcome.summary, cache_text(outcome.cache), printable(folder.string()));
  if (std::ranges::find(outcome.files, report_name) != outcome.files.end()) {
    print_output("Report: {}\n", printable((folder / report_name).string()));
  }
  if (!arguments.plot.empty()) {
    if (std::ranges::find(outcome.files, curves_name) == outcome.files.end()) {
      throw InputError("--plot: this run has no precision-recall curves; its results are complete otherwise");
    }
    write_drawing(arguments.plot, curves_plot(read_curves(folder / curves_name)));
  }
  const int replayed = request.recorded.is_null() ? exit_success : report_replay(request.recorded, folder);
  return std::max(replayed, report_run_problems(outcome));
}

/// Prints what a part has done; returns the exit status. Omitted shapes are for the run to report.
int report_part(const PartOutcome& outcome, const Part& part, const fs::path& cache) {
  const std::string rows = outcome.rows > 0 ? fmt::format(" and scores of {} rows of distances", outcome.rows) : "";
  print_output("Part {} of {}: {} of {} {}s{} in the cache {}\n", part.number, part.count, outcome.shapes, outcome.all,
               outcome.noun, rows, printable(cache.string()));
  for (const LeftOutShape& one : outcome.left_out) {
    warn(fmt::format("omitted {} {}: {}", outcome.noun, one.id, one.message));
  }
  return exit_success;
}

/// Checks what a run would check before it computes, and prints its inputs and results.
int describe_run(const RunArguments& arguments, const Experiment& experiment, const fs::path& folder) {
  check_earlier_results(folder, experiment.configuration(), arguments.replace || arguments.force);
  std::size_t files = 0;
  const nlohmann::json inputs = experiment.inputs ? experiment.inputs(arguments.threads) : nlohmann::json::object();
  for (const char* kind : {"models", "shapes"}) files += inputs.value(kind, nlohmann::json::object()).size();
  print_output("The configuration of {} is valid.\n", printable(experiment.name));
  if (files > 0) print_output("Inputs: {}\n", count_text(static_cast<std::int64_t>(files), "file", "files"));
  std::error_code unknown;
  print_output("Results: {}{}\n", printable(folder.string()),
               fs::exists(folder / manifest_name, unknown) ? ", replacing those that are there" : "");
  return exit_success;
}

int run(const RunArguments& arguments) {
  check_plot(arguments);
  const std::optional<Part> part = arguments.part.empty() ? std::nullopt : std::optional(parse_part(arguments.part));
  const RequestedRun request = requested_run(arguments.source);
  Experiment experiment = read_experiment(request.document, request.source, request.folder);
  const fs::path folder = result_folder(arguments, experiment.name);
  std::ranges::copy(request.files, std::back_inserter(experiment.input_paths));
  if (arguments.print_configuration) {
    print_output("{}\n", json_text(experiment.configuration(), 2));
    return exit_success;
  }
  if (arguments.dry_run) return describe_run(arguments, experiment, folder);
  warn_of_inputs(request, experiment, arguments.threads);
  ProgressLine progress;
  if (part) {
    const PartOutcome outcome = with_cache(arguments, progress, [&](Cache& cache, const RunControl& control) {
      return run_part(experiment, *part, folder, control, cache);
    });
    progress.clear();
    return report_part(outcome, *part, requested_cache_folder(arguments.cache));
  }
  const RunOutcome outcome = with_cache(arguments, progress, [&](Cache& cache, const RunControl& control) {
    return run_into_folder(experiment, folder, arguments.replace || arguments.force, control, cache);
  });
  progress.clear();
  return report_run(outcome, arguments, request, folder);
}

/// Adds the options of the cache and of parts; returns --part. A chart is drawn by the whole run.
CLI::Option* add_cache_and_part(CLI::App& command, RunArguments& arguments, CLI::Option* plot) {
  add_cache_option(command, arguments.cache);
  CLI::Option* const no_cache =
      command.add_flag("--no-cache", arguments.cache.none, "Neither read nor write cached results")
          ->excludes("--cache")
          ->group(computation_options);
  return add_part_option(
             command, arguments.part,
             "Compute only share K of N of the work (such as 1/4), into the cache; auto: K and N from Slurm or "
             "mpirun")
      ->excludes(no_cache)
      ->excludes(plot);
}

}  // namespace

void add_run_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "Run an experiment from its configuration");
  command->footer(
      "Example: shapegauge run configs/quickstart.json\n"
      "An interrupted run continues from the cache. After all parts of --part, a run without it writes the "
      "results.\n--replay writes to results/NAME-replay or --output, without the cache, and compares the outputs.");
  const auto arguments = std::make_shared<RunArguments>();
  begin_option_group(*command, input_options);
  CLI::Option* configuration = command->add_option("configuration", arguments->source.configuration,
                                                   "Configuration file (JSON); required without --replay");
  begin_option_group(*command, output_options);
  command->add_option("-o,--output", arguments->output,
                      "Results folder (default: results/NAME, where NAME is the experiment's name)");
  add_threads_option(*command, arguments->threads);
  begin_option_group(*command, input_options);
  command
      ->add_option(
          "--set", arguments->source.overrides,
          "Override a configuration value: dotted.key=value, such as signatures[Sum].scale=ranks for signature "
          "Sum; paths are relative to the working directory; repeatable")
      ->allow_extra_args(false);
  begin_option_group(*command, output_options);
  CLI::Option* const plot =
      command->add_option("--plot", arguments->plot, "File for a precision-recall chart: .svg, .pdf or .png");
  command->add_flag("--replace", arguments->replace,
                    "Overwrite the --plot file, and another configuration's results in the folder (default: stop)");
  command->add_flag("--force", arguments->force,
                    "Like --replace, and compute everything again, ignoring cached results");
  CLI::Option* const part = add_cache_and_part(*command, *arguments, plot);
  begin_option_group(*command, "Without a run");
  command->add_flag("--dry-run", arguments->dry_run, "Check the configuration, read all inputs, and exit");
  command->add_flag("--print-config", arguments->print_configuration,
                    "Print the configuration with defaults and --set applied, then exit");
  begin_option_group(*command, "Replay");
  command->add_option("--replay", arguments->source.replay, "manifest.json of an earlier run to repeat")
      ->excludes(configuration)
      ->excludes(part);
  command->add_option("--dataset-root", arguments->source.dataset_root,
                      "Data set folder for --replay (default: as recorded)");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
