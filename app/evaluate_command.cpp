#include "app/evaluate_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>

#include "app/evaluation_options.h"
#include "app/run_program.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/report/report_page.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct EvaluateArguments {
  fs::path distances;
  EvaluationArguments evaluation;
  ResamplingArguments resampling;
  std::string format = "table";
  std::string unit = "percent";
  std::optional<int> digits;
  fs::path curve;
  fs::path report;
  fs::path class_curves;
  fs::path per_query;
  fs::path per_class;
};

constexpr int csv_digits = 4;
constexpr int table_digits = 2;

FigureStyle style_of(const EvaluateArguments& arguments) {
  const bool percent = arguments.unit == "percent";
  const int usual = (arguments.format == "csv" ? csv_digits : table_digits) + (percent ? 0 : 2);
  return {.percent = percent, .decimals = arguments.digits.value_or(usual)};
}

std::string formatted(const NamedEvaluation& named, const std::vector<std::string>& class_names,
                      const EvaluateArguments& arguments) {
  if (arguments.format == "json") {
    return evaluation_json(*named.evaluation, class_names, named.intervals).dump(2) + "\n";
  }
  const std::vector<NamedEvaluation> one{named};
  const FigureStyle style = style_of(arguments);
  if (arguments.format == "csv") return to_csv(summary_table(one, style, IntervalCells::columns));
  const Table table =
      summary_table(one, style, named.intervals.micro.empty() ? IntervalCells::none : IntervalCells::beside);
  if (arguments.format == "markdown") return to_markdown(table);
  return arguments.format == "latex" ? to_latex(table) : to_plain_text(table);
}

void write_report(const NamedEvaluation& named, const EvaluationInput& input, const fs::path& path) {
  Report report;
  report.title = named.method;
  report.classes = input.class_names;
  report.ids = input.query_ids;
  report.labels = input.task.query_classes;
  report.methods.push_back({.name = named.method,
                            .description = {},
                            .distances = &input.distances,
                            .evaluations = {named.evaluation, 1},
                            .histograms = {}});
  write_file_atomically(path, report_page(report));
}

/// A report shows models that are all queries to all others.
void check_fit_for_report(const EvaluationInput& input) {
  const RetrievalTask& task = input.task;
  const bool all_classified = std::ranges::find(task.query_classes, no_class) == task.query_classes.end() &&
                              task.query_classes == task.target_classes;
  if (input.same_rows_and_columns && all_classified && task.judged.empty() && !task.lists_may_end_early) return;
  throw InputError(
      "--report takes a square matrix of models that are all queries and targets, each with a class; leave it out for "
      "separate queries and targets, judgements and ranked lists");
}

void write_files(const NamedEvaluation& named, const EvaluationInput& input, const EvaluateArguments& arguments) {
  const std::vector<NamedEvaluation> one{named};
  if (!arguments.curve.empty()) {
    const bool plot = arguments.curve.extension() == ".plot";
    write_file_atomically(arguments.curve,
                          plot ? psb_plot(named.evaluation->micro_curve) : to_csv(precision_recall_table(one)));
  }
  const auto write_table = [](const fs::path& path, const Table& table) { write_file_atomically(path, to_csv(table)); };
  if (!arguments.class_curves.empty()) write_table(arguments.class_curves, class_curves_table(one, input.class_names));
  if (!arguments.per_query.empty()) {
    write_table(arguments.per_query, per_query_table(one, input.query_ids, input.class_names));
  }
  if (!arguments.per_class.empty()) write_table(arguments.per_class, per_class_table(one, input.class_names));
}

int run(const EvaluateArguments& arguments) {
  const EvaluatedMatrix evaluated = evaluate_file(arguments.distances, arguments.evaluation);
  if (!arguments.report.empty()) check_fit_for_report(evaluated.input);
  std::vector<std::string> notes = evaluated.notes;
  NamedEvaluation named{.method = arguments.distances.stem().string(), .evaluation = &evaluated.evaluation};
  if (arguments.resampling.confidence > 0) {
    named.intervals = intervals_of(evaluated.evaluation, {.confidence = arguments.resampling.confidence,
                                                          .blocks = blocks_of(arguments.resampling.blocks).value(),
                                                          .resampling = arguments.resampling.resampling});
    if (named.intervals.micro.empty()) {
      notes.push_back(
          fmt::format("there are fewer than two {}, so there are no intervals", arguments.resampling.blocks));
    }
  }
  write_files(named, evaluated.input, arguments);
  if (!arguments.report.empty()) write_report(named, evaluated.input, arguments.report);
  fmt::print("{}", formatted(named, evaluated.input.class_names, arguments));
  tell(notes);
  if (arguments.format != "json") tell(notes_of_ties(evaluated.evaluation));  // JSON has their number
  return exit_success;
}

void add_output_options(CLI::App& command, EvaluateArguments& arguments) {
  command.add_option("--format", arguments.format, "Format of the result")
      ->check(CLI::IsMember({"table", "csv", "json", "markdown", "latex"}))
      ->capture_default_str();
  command.add_option("--unit", arguments.unit, "Unit of the figures in tables; JSON is always in fractions")
      ->check(CLI::IsMember({"percent", "fraction"}))
      ->capture_default_str();
  command.add_option("--digits", arguments.digits, "Digits behind the point in tables")->check(CLI::Range(0, 15));
  command.add_option("--pr", arguments.curve, "File for the precision-recall curve: .csv, or .plot as psbPlot has it");
  command.add_option("--pr-per-class", arguments.class_curves, "CSV file for the curves of the classes");
  command.add_option("--curve", arguments.evaluation.curve, "How curves are drawn (default: the protocol's own way)")
      ->check(CLI::IsMember(curve_kind_names()));
  command.add_option("--per-query", arguments.per_query,
                     "CSV file for the figures of each query, as 'compare' reads it");
  command.add_option("--per-class", arguments.per_class, "CSV file for the figures of each class");
  command.add_option("--report", arguments.report, "HTML file for a page that shows the result");
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Evaluate distances, features or ranked lists, of any method, against classes");
  command->footer(
      "Example: shapegauge evaluate distances.npy --labels test.cla --protocol psb --format json\n"
      "Row i of the matrix is the i-th model of the classification in natural order (2 before 10), unless the matrix\n"
      "(CSV), --ids or --order says otherwise: Princeton's own tools order the rows as the classification does.\n"
      "Tables are in percent, JSON in fractions. 'shapegauge measures' explains the measures.");
  const auto arguments = std::make_shared<EvaluateArguments>();
  command
      ->add_option(
          "distances", arguments->distances,
          "Distances or features: .matrix (PSB), .npy, .csv, .txt or .dat; or ranked lists: .run, .trec, .lists")
      ->required();
  add_evaluation_options(*command, arguments->evaluation);
  add_output_options(*command, *arguments);
  add_resampling_options(*command, arguments->resampling);
  command->callback([arguments, &status] {
    arguments->evaluation.files.whole_matrix = !arguments->report.empty();  // it shows the matrix
    status = run(*arguments);
  });
}

}  // namespace shapegauge
