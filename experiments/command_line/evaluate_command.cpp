#include "shapegauge/experiments/command_line/evaluate_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <memory>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/command_line/exit_status.h"
#include "shapegauge/experiments/datasets/classification_file.h"
#include "shapegauge/experiments/matrices/distance_matrix_file.h"
#include "shapegauge/experiments/report/report_page.h"
#include "shapegauge/experiments/results/evaluation_json.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/text/lines.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct EvaluateArguments {
  fs::path distances;
  fs::path labels;
  fs::path ids;
  std::string order = "natural";
  std::string protocol = "psb";
  std::string format = "table";
  int minimum_class_size = 2;
  fs::path curve;
  fs::path report;
};

/// The ids in a file, one a line; empty lines do not count.
std::vector<std::string> read_ids(const fs::path& path) {
  const std::string text = read_file_bytes(path);
  std::vector<std::string> ids;
  for (const std::string_view line : split_lines(text)) {
    const std::string_view id = without_outer_blanks(line);
    if (!id.empty()) ids.emplace_back(id);
  }
  return ids;
}

/// The id of each row: as --ids says, else as the matrix says, else the classification's models in the order asked for.
std::vector<std::string> row_ids(const EvaluateArguments& arguments, const LabelledDistances& matrix,
                                 const Classification& classification) {
  if (!arguments.ids.empty()) return read_ids(arguments.ids);
  if (!matrix.ids.empty()) return matrix.ids;
  return arguments.order == "natural" ? models_in_natural_order(classification) : models_in_file_order(classification);
}

std::string formatted(const Evaluation& evaluation, const std::vector<std::string>& class_names,
                      const EvaluateArguments& arguments) {
  if (arguments.format == "json") return evaluation_json(evaluation, class_names).dump(2) + "\n";
  const std::vector<NamedEvaluation> one{{.method = arguments.distances.stem().string(), .evaluation = &evaluation}};
  if (arguments.format == "csv") return to_csv(summary_table(one, 4));
  const Table table = summary_table(one, 2);
  if (arguments.format == "markdown") return to_markdown(table);
  return arguments.format == "latex" ? to_latex(table) : to_plain_text(table);
}

void write_report(const EvaluateArguments& arguments, const LabelledDistances& matrix,
                  const std::vector<std::string>& ids, const std::vector<int>& labels,
                  const std::vector<std::string>& class_names, const Evaluation& evaluation) {
  const std::string name = arguments.distances.stem().string();
  Report report;
  report.title = name;
  report.classes = class_names;
  report.ids = ids;
  report.labels = labels;
  report.methods.push_back({.name = name,
                            .description = {},
                            .distances = &matrix.distances,
                            .evaluations = {&evaluation, 1},
                            .histograms = {}});
  write_file_atomically(arguments.report, report_page(report));
}

int run(const EvaluateArguments& arguments) {
  const Classification classification = read_classification(arguments.labels);
  const LabelledDistances matrix = read_distance_matrix(arguments.distances);
  const std::vector<std::string> ids = row_ids(arguments, matrix, classification);
  if (static_cast<std::size_t>(matrix.distances.rows()) != ids.size()) {
    throw InputError(fmt::format("{} has {} rows, but there are {} models in {}", arguments.distances.string(),
                                 matrix.distances.rows(), ids.size(),
                                 (arguments.ids.empty() ? arguments.labels : arguments.ids).string()));
  }
  const std::vector<int> labels = class_labels(classification, ids, arguments.labels.string());
  const Evaluation evaluation = evaluate(
      matrix.distances, labels,
      {.protocol = protocol_of(arguments.protocol).value(), .minimum_class_size = arguments.minimum_class_size});
  std::vector<std::string> class_names;
  for (const ModelClass& model_class : classification.classes) class_names.push_back(model_class.name);

  if (!arguments.curve.empty()) {
    const std::vector<NamedEvaluation> one{{.method = arguments.distances.stem().string(), .evaluation = &evaluation}};
    write_file_atomically(arguments.curve, to_csv(precision_recall_table(one)));
  }
  if (!arguments.report.empty()) write_report(arguments, matrix, ids, labels, class_names, evaluation);
  fmt::print("{}", formatted(evaluation, class_names, arguments));
  if (evaluation.models_left_out > 0) {
    fmt::print(stderr, "shapegauge: note: {} models are never queries, as their classes have fewer than {} models\n",
               evaluation.models_left_out, arguments.minimum_class_size);
  }
  return exit_success;
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Evaluate a distance matrix, of any method, against a classification");
  command->footer(
      "Example: shapegauge evaluate distances.npy --labels test.cla --protocol psb --format json\n"
      "Row i of the matrix is the i-th model of the classification in natural order (2 before 10), unless the matrix\n"
      "(CSV), --ids or --order says otherwise: Princeton's own tools order the rows as the classification does.\n"
      "Tables are in percent, JSON in fractions.");
  const auto arguments = std::make_shared<EvaluateArguments>();
  command->add_option("distances", arguments->distances, "Distance matrix: .matrix (PSB), .npy, .csv, .txt or .dat")
      ->required();
  command->add_option("--labels", arguments->labels, "Classification (.cla)")->required();
  command->add_option("--ids", arguments->ids, "Ids of the rows, one a line");
  command
      ->add_option("--order", arguments->order,
                   "Which model a row is where no ids say so: the i-th in natural order, or in the classification's")
      ->check(CLI::IsMember({"natural", "classification"}))
      ->capture_default_str();
  command->add_option("--protocol", arguments->protocol, "Evaluation protocol")
      ->check(CLI::IsMember(protocol_names()))
      ->capture_default_str();
  command->add_option("--min-class-size", arguments->minimum_class_size, "Models of smaller classes are never queries")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command->add_option("--format", arguments->format, "Format of the result")
      ->check(CLI::IsMember({"table", "csv", "json", "markdown", "latex"}))
      ->capture_default_str();
  command->add_option("--pr", arguments->curve, "CSV file for the precision-recall curve");
  command->add_option("--report", arguments->report, "HTML file for a page that shows the result");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
