// SPDX-License-Identifier: GPL-3.0-or-later

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/evaluation_arguments.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/standard_streams.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/evaluation_plots.h"
#include "shapegauge/experiments/results/evaluation_report.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct EvaluateCommandArguments {
  fs::path distances;  ///< "-" for standard input
  std::string input_format;
  EvaluationArguments evaluation;
  ResamplingArguments resampling;
  ScoreFormat printed;
  fs::path curve;
  fs::path report;
  fs::path class_curves;
  fs::path per_query;
  fs::path per_class;
  fs::path plot;
  fs::path class_plot;
  bool each_query = false;
  bool replace = false;
};

// Returns the inputs of a result as JSON, before the scores.
nlohmann::ordered_json inputs_json(const fs::path& path, const EvaluateCommandArguments& arguments) {
  const EvaluationFiles& files = arguments.evaluation.files;
  nlohmann::ordered_json json{{"version", version()}, {"file", path.string()}};
  if (!arguments.evaluation.evaluator.empty()) json["evaluator"] = arguments.evaluation.evaluator;
  if (!files.variable.empty()) json["variable"] = files.variable;
  if (!files.labels.empty()) json["labels"] = files.labels.string();
  if (!files.targets.empty()) json["targets"] = files.targets.string();
  if (files.shared_ids) json["shared_ids"] = true;
  if (!files.qrels.empty()) json["qrels"] = files.qrels.string();
  if (!files.ids.empty()) json["ids"] = files.ids.string();
  if (!files.distance.empty()) json["distance"] = files.distance;
  if (files.similarity) json["similarity"] = true;
  return json;
}

// Returns the coverage of ranked lists as JSON.
nlohmann::ordered_json coverage_json(const ListCoverage& coverage, const std::string& missing_queries) {
  return {{"queries", coverage.queries},        {"answered", coverage.answered},
          {"missing_queries", missing_queries}, {"shortest_list", coverage.shortest},
          {"longest_list", coverage.longest},   {"incomplete_lists", coverage.incomplete}};
}

// Evaluated inputs: the file of the command, or the matrices of a run.
struct EvaluatedInputs {
  std::unique_ptr<ScratchFolder> scratch = {};  // with a copy of standard input
  std::vector<fs::path> paths = {};
  std::vector<EvaluatedFiles> files = {};
  std::vector<NamedEvaluation> named = {};  // refer to the files

  [[nodiscard]] const EvaluationTask& task() const { return files.front().data.task; }
};

nlohmann::ordered_json evaluated_json(const fs::path& path, const NamedEvaluation& named, const EvaluationTask& task,
                                      const EvaluateCommandArguments& arguments) {
  nlohmann::ordered_json json = inputs_json(path, arguments);
  json["method"] = named.method;
  if (task.coverage) json["lists"] = coverage_json(*task.coverage, arguments.evaluation.missing_queries);
  json.update(evaluation_json(*named.evaluation, task.class_names, named.intervals));
  if (arguments.each_query) json["per_query"] = per_query_json(*named.evaluation, task.query_ids);
  return json;
}

std::string formatted_json(const EvaluatedInputs& inputs, const EvaluateCommandArguments& arguments) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < inputs.named.size(); ++i) {
    all.push_back(evaluated_json(inputs.paths[i], inputs.named[i], inputs.files[i].data.task, arguments));
  }
  return json_text(all.size() > 1 ? all : all.front(), 2) + "\n";
}

std::string formatted_evaluation(const EvaluatedInputs& inputs, const EvaluateCommandArguments& arguments) {
  if (arguments.printed.format == "json") return formatted_json(inputs, arguments);
  const EvaluationTask& task = inputs.task();
  const ScoreStyle style = style_of(arguments.printed);
  const IntervalCells intervals = arguments.printed.format == "csv"      ? IntervalCells::columns
                                  : arguments.resampling.confidence == 0 ? IntervalCells::none
                                                                         : IntervalCells::in_cells;
  const auto format = value_of_word<TableFormat>(arguments.printed.format).value();
  const auto text_of = [&](const TextTable& table) { return table_text(table, format, output_has_colours()); };
  std::string text;
  if (arguments.each_query)
    text = text_of(per_query_table(inputs.named, task.query_ids, task.class_names, style)) + "\n";
  const TextTable summary = summary_table(inputs.named, style, intervals);
  return text + text_of(format == TableFormat::table ? merge_equal_averages(summary) : summary);
}

/// Throws InputError unless all models are queries to all others, as reports require.
void check_fit_for_report(const EvaluationTask& task) {
  if (is_fit_for_report(task)) return;
  throw InputError(
      "--report requires a square matrix whose models all have a class and are both queries and targets; omit it for "
      "separate queries and targets, judgements and ranked lists");
}

void write_files(const EvaluatedInputs& inputs, const EvaluateCommandArguments& arguments) {
  const std::vector<NamedEvaluation>& named = inputs.named;
  const EvaluationTask& task = inputs.task();
  if (!arguments.curve.empty()) {
    const bool plot = lower_case(arguments.curve.extension().string()) == ".plot";
    write_file_atomically(arguments.curve, plot ? psb_plot(named.front().evaluation->micro_curve)
                                                : to_csv(precision_recall_table(named)));
  }
  const auto write_table = [](const fs::path& path, const TextTable& table) {
    write_file_atomically(path, to_csv(table));
  };
  if (!arguments.class_curves.empty()) write_table(arguments.class_curves, class_curves_table(named, task.class_names));
  if (!arguments.per_query.empty()) {
    write_table(arguments.per_query, per_query_table(named, task.query_ids, task.class_names));
  }
  if (!arguments.per_class.empty()) write_table(arguments.per_class, per_class_table(named, task.class_names));
}

/// Returns the format identified by the first bytes; text without a format is CSV.
std::string_view sniffed_format(std::string_view bytes) {
  if (bytes.starts_with("\x93NUMPY")) return "npy";
  if (bytes.starts_with("PK\x03\x04")) return "npz";
  if (bytes.starts_with("\x1F\x8B")) {
    throw InputError("standard input is compressed; decompress it first, as by gunzip -c");
  }
  return bytes.starts_with("MATLAB 5.0") ? "mat" : "csv";
}

/// Returns the extensions of matrices and ranked lists without their dots.
std::vector<std::string> input_formats() {
  std::vector<std::string> formats;
  for (const std::string_view extension : matrix_extensions()) formats.emplace_back(extension.substr(1));
  for (const std::string_view extension : ranked_answers_extensions) formats.emplace_back(extension.substr(1));
  return formats;
}

/// Evaluates standard input. Copies it to a file in the folder first, since matrices are read in blocks.
EvaluatedFiles evaluate_standard_input(const EvaluateCommandArguments& arguments, const ScratchFolder& scratch) {
  const std::string bytes = read_standard_input();
  const std::string format =
      arguments.input_format.empty() ? std::string(sniffed_format(bytes)) : arguments.input_format;
  const fs::path file = scratch.path() / ("standard input." + format);
  write_file_atomically(file, bytes);
  try {
    return evaluate_with_progress(file, arguments.evaluation);
  } catch (const InputError& error) {
    std::string message = error.what();
    if (const auto at = message.find(file.string()); at != std::string::npos) {
      message.replace(at, file.string().size(), "standard input");
    }
    throw InputError(message);
  }
}

// Returns true for the folder of a run.
bool is_run(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path / manifest_name, unknown);
}

/// Throws InputError for unusable output files, before any work.
void check_outputs(const EvaluateCommandArguments& arguments) {
  std::vector<fs::path> inputs = label_files(arguments.evaluation);
  inputs.push_back(arguments.distances);
  if (is_folder(arguments.distances) && !is_run(arguments.distances)) {
    std::ranges::move(ranked_list_files(arguments.distances), std::back_inserter(inputs));
  }
  const std::vector<std::string> csv{".csv"};
  const std::vector<OutputFile> outputs{
      {.path = arguments.curve, .what = "--pr", .extensions = {".csv", ".plot"}},
      {.path = arguments.class_curves, .what = "--pr-per-class", .extensions = csv},
      {.path = arguments.per_query, .what = "--per-query", .extensions = csv},
      {.path = arguments.per_class, .what = "--per-class", .extensions = csv},
      {.path = arguments.plot, .what = "--plot"},
      {.path = arguments.class_plot, .what = "--plot-classes"},
      {.path = arguments.report, .what = "--report", .extensions = page_extensions},
  };
  for (const fs::path& plot : {arguments.plot, arguments.class_plot}) {
    if (!plot.empty()) check_drawing_file(plot);
  }
  check_output_files(inputs, outputs, arguments.replace);
}

// Returns the distance matrices of a run.
std::vector<fs::path> matrices_of_run(const fs::path& run) {
  std::vector<fs::path> matrices;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(run / "distances", failure)) {
    if (entry.path().extension() == ".npy") matrices.push_back(entry.path());
  }
  if (matrices.empty())
    throw InputError(
        fmt::format("{}: the run has no distance matrices; run it again with \"keep_distances\": true", run.string()));
  std::ranges::sort(matrices);
  return matrices;
}

// Adds an evaluated file with its intervals and warnings.
void add_evaluated(const fs::path& path, EvaluatedFiles evaluated, const EvaluateCommandArguments& arguments,
                   EvaluatedInputs& inputs, std::vector<std::string>& warnings) {
  const EvaluatedFiles& files = inputs.files.emplace_back(std::move(evaluated));
  inputs.paths.push_back(path);
  const std::string name = is_standard_stream(path) ? "standard input" : path.string();
  NamedEvaluation& named = inputs.named.emplace_back(
      NamedEvaluation{.method = method_name(name, files.data), .evaluation = &files.evaluation});
  std::vector<std::string> found = files.warnings;
  if (arguments.resampling.confidence > 0) {
    const BusyLine line("resampling");
    named.intervals =
        intervals_of(files.evaluation, {.confidence = arguments.resampling.confidence,
                                        .blocks = value_of_word<ResamplingUnit>(arguments.resampling.blocks).value(),
                                        .resampling = arguments.resampling.resampling});
    if (named.intervals.micro.empty()) {
      found.push_back(fmt::format("no intervals: fewer than two {}", arguments.resampling.blocks));
    }
  }
  const auto tied = ties_warning(files.evaluation, files.findings);
  if (tied && arguments.printed.format != "json") found.push_back(*tied);  // JSON has their number
  for (const std::string& warning : found) {
    warnings.push_back(is_run(arguments.distances) ? fmt::format("{}: {}", named.method, warning) : warning);
  }
}

// Evaluates the input of the command. The labels of a run are those of its models.
EvaluatedInputs evaluate_inputs(EvaluateCommandArguments& arguments, std::vector<std::string>& warnings) {
  EvaluatedInputs inputs;
  if (is_standard_stream(arguments.distances)) {
    inputs.scratch = std::make_unique<ScratchFolder>();
    add_evaluated(arguments.distances, evaluate_standard_input(arguments, *inputs.scratch), arguments, inputs,
                  warnings);
    return inputs;
  }
  std::vector<fs::path> paths{arguments.distances};
  EvaluationFiles& files = arguments.evaluation.files;
  if (is_run(arguments.distances)) {
    paths = matrices_of_run(arguments.distances);
    if (files.labels.empty() && files.qrels.empty()) files.labels = arguments.distances / "shapes.csv";
  }
  inputs.files.reserve(paths.size());  // NamedEvaluation refers to them
  for (const fs::path& path : paths) {
    add_evaluated(path, evaluate_with_progress(path, arguments.evaluation), arguments, inputs, warnings);
  }
  return inputs;
}

void write_charts(const EvaluatedInputs& inputs, const EvaluateCommandArguments& arguments) {
  std::vector<NamedCurve> curves;
  for (const NamedEvaluation& named : inputs.named) curves.push_back(named_curve(named));
  if (!arguments.plot.empty()) write_drawing(arguments.plot, curves_plot(curves));
  if (arguments.class_plot.empty()) return;
  const std::string& measure = inputs.named.front().evaluation->measures.front();
  write_drawing(arguments.class_plot, class_plot(inputs.named, inputs.task().class_names, measure));
}

void write_report(const EvaluatedInputs& inputs, const EvaluateCommandArguments& arguments) {
  if (arguments.report.empty()) return;
  std::vector<ReportedEvaluation> reported;
  for (std::size_t i = 0; i < inputs.named.size(); ++i) {
    reported.push_back({.named = inputs.named[i], .data = &inputs.files[i].data});
  }
  write_file_atomically(arguments.report, evaluation_report_page(reported));
}

int run(EvaluateCommandArguments& arguments) {
  check_outputs(arguments);
  if (!is_standard_stream(arguments.distances) && !arguments.input_format.empty()) {
    throw InputError(
        "--input-format applies to standard input (-) only; the format of a file follows from its extension");
  }
  std::vector<std::string> warnings;
  const EvaluatedInputs inputs = evaluate_inputs(arguments, warnings);
  if (!inputs.task().coverage && arguments.evaluation.missing_queries == word_of(Unanswered::count)) {
    throw InputError("--missing-queries zero applies to ranked lists only: a matrix has an answer to each query");
  }
  if (!arguments.report.empty()) check_fit_for_report(inputs.task());
  write_files(inputs, arguments);
  write_charts(inputs, arguments);
  write_report(inputs, arguments);
  print_output("{}", formatted_evaluation(inputs, arguments));
  print_warnings(warnings);
  return exit_success;
}

void add_output_options(CLI::App& command, EvaluateCommandArguments& arguments) {
  begin_option_group(command, output_options);
  add_score_format_options(command, arguments.printed, "Format of the printed result");
  command.add_option("--pr", arguments.curve,
                     "File for the precision-recall curve: .csv, or .plot (format of Princeton's psbPlot)");
  command.add_option("--pr-per-class", arguments.class_curves, "CSV file for precision-recall curves per class");
  command
      .add_option(
          "--curve", arguments.evaluation.curve,
          "Interpolation of precision-recall curves between hits. psb: linear; paper: previous hit; trec: best "
          "later hit; trec_eval: like trec, with recall rounded to whole hits; raw: none (default: the protocol's)")
      ->check(one_of(list_of_words<CurveKind>()));
  command.add_option("--per-query", arguments.per_query, "CSV file for scores per query, for 'compare'");
  command.add_flag("--each-query", arguments.each_query, "Also print the scores of each query, as trec_eval -q");
  command
      .add_flag_callback("-q",
                         [] {
                           throw InputError(
                               "-q is ambiguous after evaluate: use --each-query for the scores of each query, or "
                               "--quiet for no messages except warnings and errors");
                         })
      ->group(hidden_options);  // not in the help
  command.add_option("--per-class", arguments.per_class, "CSV file for scores per class");
  command.add_option("--plot", arguments.plot, "File for a precision-recall chart: .svg, .pdf or .png");
  command.add_option("--plot-classes", arguments.class_plot,
                     "File for a per-class chart of the first printed measure: .svg, .pdf or .png");
  command.add_option("--report", arguments.report,
                     "HTML report with scores and curves; requires square distance matrices");
  add_replace_option(command, arguments.replace);
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Evaluate distances, features or ranked lists of any method against classes");
  command->footer(
      "Example: shapegauge evaluate distances.npy --labels test.cla\n"
      "         shapegauge evaluate results.run --qrels judgements.txt --format json\n"
      "Princeton's tools write rows in the order of the .cla file: --order file.\n'shapegauge measures' explains the "
      "measures.");
  const auto arguments = std::make_shared<EvaluateCommandArguments>();
  command
      ->add_option(
          "distances", arguments->distances,
          fmt::format(
              "Distances or features ({}) or ranked lists ({}, .txt); .npy and text may be compressed (.gz); a result "
              "folder of 'run' (all its methods); - for standard input",
              fmt::join(matrix_extensions(), ", "), fmt::join(ranked_answers_extensions, ", ")))
      ->required();
  begin_option_group(*command, input_options);
  command
      ->add_option("--input-format", arguments->input_format,
                   "Format of standard input, as a file extension (default: detected, otherwise csv)")
      ->check(one_of(input_formats()));
  add_evaluation_options(*command, arguments->evaluation);
  add_output_options(*command, *arguments);
  add_resampling_options(*command, arguments->resampling);
  command->callback(
      [arguments, &status] { with_threads(arguments->evaluation.threads, [&] { status = run(*arguments); }); });
}

}  // namespace shapegauge
