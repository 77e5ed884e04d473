// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/commands.h"
#include "app/evaluation_arguments.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/evaluation_plots.h"
#include "shapegauge/experiments/results/evaluation_report.h"
#include "shapegauge/experiments/results/method_comparison_tables.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::vector<fs::path> inputs;
  EvaluationArguments evaluation;
  std::vector<std::string> of_distances;  // options used on the command line that act on distances only
  ResamplingArguments resampling{.blocks = "queries", .confidence = 0.95, .resampling = {}};
  std::string test{word_of(ComparisonOptions{}.test)};
  std::string average = "micro";
  std::string reference;
  std::vector<std::string> names;
  ScoreFormat printed;
  fs::path plot;
  fs::path score_plot;
  fs::path curves;
  fs::path report;
  bool replace = false;
};

// Returns true for the folder of a run and for a table of scores: all inputs without labels or judgements.
bool has_scores(const fs::path& input, const CompareArguments& arguments) {
  const EvaluationFiles& files = arguments.evaluation.files;
  return is_folder(input) || (files.labels.empty() && files.qrels.empty());
}

bool all_have_scores(const CompareArguments& arguments) {
  return std::ranges::all_of(arguments.inputs, [&](const fs::path& input) { return has_scores(input, arguments); });
}

// Inputs of a comparison, with the data for curves and reports.
struct ComparedInputs {
  std::vector<MethodScores> methods;
  std::vector<NamedCurve> curves;         // none for tables of scores
  std::vector<EvaluatedFiles> evaluated;  // of matrices, if a report is requested
  std::vector<FileWarning> warnings;
};

// Returns the methods of a table under one protocol: the only one, or the requested one.
std::vector<MethodScores> methods_of_table(const fs::path& path, const CompareArguments& arguments) {
  const std::string protocol = name_of(chosen_protocol(arguments.evaluation));
  std::vector<MethodScores> methods = read_method_scores(path);
  const bool one =
      std::ranges::all_of(methods, [&](const MethodScores& method) { return method.protocol == methods[0].protocol; });
  if (one && arguments.evaluation.protocol.empty()) return methods;
  std::erase_if(methods, [&](const MethodScores& method) { return method.protocol != protocol; });
  if (methods.empty()) {
    throw InputError(
        fmt::format("{}: no scores under the protocol {}; choose another with --protocol", path.string(), protocol));
  }
  return methods;
}

// Returns true if curves are requested.
bool wants_curves(const CompareArguments& arguments) { return !arguments.plot.empty() || !arguments.curves.empty(); }

// Adds the curves of a run's folder, under the protocol of its scores.
void add_curves_of_run(const fs::path& folder, const CompareArguments& arguments, const std::string& protocol,
                       ComparedInputs& compared) {
  if (!wants_curves(arguments)) return;
  for (NamedCurve& curve : read_curves(folder / curves_name, value_of_word<Average>(arguments.average).value())) {
    if (curve.protocol == protocol) compared.curves.push_back(std::move(curve));
  }
}

// Throws InputError if the scores of a run, which stand next to those of evaluated distances, have another rule of
// ties.
void check_ties_of_run(const fs::path& folder, const CompareArguments& arguments) {
  std::error_code unknown;
  const fs::path summary = folder / "summary.json";
  if (all_have_scores(arguments) || !fs::exists(summary, unknown)) return;
  const auto json = nlohmann::json::parse(read_file_bytes(summary), nullptr, false);
  const std::string ties = json.is_object() ? json.value("ties", arguments.evaluation.ties) : arguments.evaluation.ties;
  if (ties == arguments.evaluation.ties) return;
  throw InputError(
      fmt::format("{}: the scores of the run are with --ties {}, those of the distances with --ties {}; use "
                  "--ties {}",
                  folder.string(), ties, arguments.evaluation.ties, ties));
}

// Adds the methods of one input with its warnings.
void add_methods(const fs::path& path, const CompareArguments& arguments, ComparedInputs& compared) {
  const auto add = [&](std::vector<MethodScores> methods) {
    std::ranges::move(methods, std::back_inserter(compared.methods));
  };
  if (is_folder(path)) {
    check_ties_of_run(path, arguments);
    add(methods_of_table(path / per_query_name, arguments));
    return add_curves_of_run(path, arguments, compared.methods.back().protocol, compared);
  }
  if (has_scores(path, arguments)) {
    if (wants_curves(arguments)) {
      throw InputError(fmt::format(
          "{}: tables of scores have no curves; use the folder of the run, or distances with --labels", path.string()));
    }
    return add(methods_of_table(path, arguments));
  }
  EvaluatedFiles evaluated = evaluate_with_progress(path, arguments.evaluation);
  for (const std::string& text : evaluated.warnings) compared.warnings.push_back({path.string(), text});
  if (const auto tied = ties_warning(evaluated.evaluation, evaluated.findings)) {
    compared.warnings.push_back({path.string(), *tied});
  }
  const std::string name = method_name(path, evaluated.data);
  add({method_scores(name, path.string(), evaluated.data.task, evaluated.evaluation)});
  compared.curves.push_back(named_curve({.method = name, .evaluation = &evaluated.evaluation},
                                        value_of_word<Average>(arguments.average).value()));
  if (arguments.report.empty()) return;
  if (!is_fit_for_report(evaluated.data.task)) {
    throw InputError(fmt::format(
        "{}: --report requires square matrices whose models all have a class and are both queries and targets",
        path.string()));
  }
  compared.evaluated.push_back(std::move(evaluated));
}

// Returns the files that are read; of the folder of a run, its tables.
std::vector<fs::path> files_read(const CompareArguments& arguments) {
  std::vector<fs::path> files = label_files(arguments.evaluation);
  for (const fs::path& input : arguments.inputs) {
    files.push_back(input);
    if (is_folder(input)) files.insert(files.end(), {input / per_query_name, input / curves_name});
  }
  return files;
}

// Throws InputError for options of distances if there are none.
void check_options_act(const CompareArguments& arguments) {
  if (!all_have_scores(arguments) || arguments.of_distances.empty()) return;
  throw InputError(fmt::format(
      "{} has no effect on the scores of a run or a table, which are as they were evaluated; omit it, or compare "
      "distances with --labels or --qrels",
      arguments.of_distances.front()));
}

void check_compare_outputs(const CompareArguments& arguments) {
  for (const fs::path& plot : {arguments.plot, arguments.score_plot}) {
    if (!plot.empty()) check_drawing_file(plot);
  }
  for (const fs::path& input : arguments.inputs) {
    if (arguments.report.empty() || !has_scores(input, arguments)) continue;
    throw InputError(fmt::format(
        "{}: --report requires distance matrices and --labels; of a run, use the files in its folder distances",
        input.string()));
  }
  const std::vector<OutputFile> outputs{{.path = arguments.plot, .what = "--plot"},
                                        {.path = arguments.score_plot, .what = "--plot-scores"},
                                        {.path = arguments.curves, .what = "--pr", .extensions = {".csv"}},
                                        {.path = arguments.report, .what = "--report", .extensions = page_extensions}};
  check_output_files(files_read(arguments), outputs, arguments.replace);
}

// Makes a table of the curves, as written by `evaluate --pr`.
TextTable curves_table(const std::vector<NamedCurve>& curves) {
  TextTable table{.header = {"method", "protocol", "recall", "precision"}, .rows = {}, .text_columns = 2};
  for (const NamedCurve& named : curves) {
    for (std::size_t i = 0; i < named.curve.recall.size(); ++i) {
      table.rows.push_back({named.method, named.protocol, fmt::format("{}", named.curve.recall[i]),
                            fmt::format("{:.6f}", named.curve.precision[i])});
    }
  }
  return table;
}

std::string explanation(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                        const ComparisonOptions& options) {
  return fmt::format(
      "{} queries of {}, protocol {}, {} averages, {:g} % intervals and tests over {}.\n"
      "A letter after a score: significantly better than that method on {} ({} test, Holm's correction, p <= {:g}).\n"
      "A letter with *: on classes like these (p_classes: t-test of the means of classes, Holm's correction).\n",
      methods.classes.size(), count_text(comparisons[0].classes, "class", "classes"), methods.protocol,
      name_of(options.average), 100 * options.confidence, name_of(options.blocks),
      options.blocks == ResamplingUnit::queries ? "these classes" : "classes like these", name_of(options.test),
      significance_level(options.confidence));
}

void write_compared(const CompareArguments& arguments, ComparedInputs& compared, const AlignedMethods& aligned,
                    const std::vector<MethodComparison>& comparisons, const ComparisonOptions& options) {
  if (compared.curves.size() == aligned.methods.size()) {
    for (std::size_t i = 0; i < compared.curves.size(); ++i) compared.curves[i].method = aligned.methods[i];
  }
  if (!arguments.plot.empty()) write_drawing(arguments.plot, curves_plot(compared.curves));
  if (!arguments.curves.empty()) write_file_atomically(arguments.curves, to_csv(curves_table(compared.curves)));
  if (!arguments.score_plot.empty()) {
    write_drawing(arguments.score_plot,
                  scores_plot(aligned.methods, aligned.measures, comparisons, arguments.resampling.confidence));
  }
  if (arguments.report.empty()) return;
  const IntervalOptions intervals{
      .confidence = options.confidence, .blocks = options.blocks, .resampling = options.resampling};
  std::vector<ReportedEvaluation> reported;
  for (std::size_t i = 0; i < compared.evaluated.size(); ++i) {
    const EvaluatedFiles& one = compared.evaluated[i];
    reported.push_back({.named = {.method = aligned.methods[i],
                                  .evaluation = &one.evaluation,
                                  .intervals = intervals_of(one.evaluation, intervals)},
                        .data = &one.data});
  }
  write_file_atomically(
      arguments.report,
      evaluation_report_page(reported, {.pairs = pairs_table(aligned, comparisons, style_of(arguments.printed), false),
                                        .words = explanation(aligned, comparisons, options)}));
}

ComparisonOptions options_of(const CompareArguments& arguments, const std::vector<std::string>& methods) {
  ComparisonOptions options;
  options.test = value_of_word<PairTest>(arguments.test).value();
  options.blocks = value_of_word<ResamplingUnit>(arguments.resampling.blocks).value();
  options.average = value_of_word<Average>(arguments.average).value();
  options.confidence = arguments.resampling.confidence;
  options.resampling = arguments.resampling.resampling;
  if (arguments.reference.empty()) return options;
  const auto found = std::ranges::find(methods, arguments.reference);
  if (found == methods.end()) {
    throw InputError(fmt::format("--reference: there is no method \"{}\"{}", arguments.reference,
                                 suggestion(arguments.reference, methods)));
  }
  options.reference = static_cast<std::size_t>(found - methods.begin());
  return options;
}

std::string formatted_comparison(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                                 const ComparisonOptions& options, const CompareArguments& arguments) {
  const ScoreStyle style = style_of(arguments.printed);
  if (arguments.printed.format == "json") return json_text(comparison_json(methods, comparisons, options), 2) + "\n";
  const bool csv = arguments.printed.format == "csv";
  const TextTable pairs = pairs_table(methods, comparisons, style, csv);
  if (csv) return to_csv(pairs);
  const TextTable summary = comparison_summary(methods, comparisons, options, style);
  const std::string words = explanation(methods, comparisons, options);
  const auto format = value_of_word<TableFormat>(arguments.printed.format).value();
  const auto text_of = [&](const TextTable& table) { return table_text(table, format, output_has_colours()); };
  if (format == TableFormat::latex) return text_of(summary);
  return text_of(summary) + "\n" + words + "\n" + text_of(pairs);
}

void warn_of_same_files(std::span<const fs::path> inputs, std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code unknown;
      if (!fs::equivalent(inputs[j], inputs[i], unknown)) continue;
      warnings.push_back(fmt::format("{} and {} are the same file; omit one", inputs[j].string(), inputs[i].string()));
    }
  }
}

int run(const CompareArguments& arguments) {
  check_compare_outputs(arguments);
  check_options_act(arguments);
  ComparedInputs compared;
  for (const fs::path& input : arguments.inputs) add_methods(input, arguments, compared);
  std::vector<std::string> warnings = merged_warnings(compared.warnings, "files");
  const AlignedMethods aligned = align_methods(compared.methods, arguments.evaluation.measures, arguments.names);
  const ComparisonOptions options = options_of(arguments, aligned.methods);
  std::vector<MethodComparison> comparisons;
  {
    const BusyLine line("comparing the methods");
    for (const Eigen::MatrixXd& values : aligned.values) {
      comparisons.push_back(compare_methods(values, aligned.classes, options));
    }
  }
  warn_of_same_files(arguments.inputs, warnings);
  if (const auto few = few_units_warning(comparisons.front(), options)) {
    warnings.push_back(*few);
  }
  write_compared(arguments, compared, aligned, comparisons, options);
  print_warnings(warnings);
  print_output("{}", formatted_comparison(aligned, comparisons, options, arguments));
  return exit_success;
}

void add_comparison_options(CLI::App& command, CompareArguments& arguments) {
  begin_option_group(command, "Comparison");
  command.add_option("--test", arguments.test, "Paired significance test: randomisation, t-test (t) or bootstrap")
      ->check(one_of(list_of_words<PairTest>()))
      ->capture_default_str()
      ->transform([](const std::string& name) { return name == "randomization" ? "randomisation" : name; });  // older
  command
      .add_option("--average", arguments.average, "Average of scores over queries (micro) or over class means (macro)")
      ->check(one_of(list_of_words<Average>()))
      ->capture_default_str();
  command.add_option("--reference", arguments.reference,
                     "Name of the method to compare with the others (default: compare all pairs)");
  command
      .add_option("--names", arguments.names,
                  "Method names in input order, such as ours,theirs (default: from the inputs)")
      ->delimiter(',');
  begin_option_group(command, output_options);
  command.add_option("--plot", arguments.plot, "File for a precision-recall chart: .svg, .pdf or .png");
  command.add_option("--plot-scores", arguments.score_plot,
                     "File for a chart of average scores with confidence intervals: .svg, .pdf or .png");
  command.add_option("--pr", arguments.curves, "CSV file for precision-recall curves of all methods");
  command.add_option("--report", arguments.report,
                     "HTML report with scores and curves; requires square distance matrices and --labels");
  add_replace_option(command, arguments.replace);
  add_score_format_options(command, arguments.printed,
                           "Format of the printed result; csv: differences of pairs only; latex: scores only");
}

}  // namespace

void add_compare_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("compare", "Compare methods on the same queries with intervals and significance tests");
  command->footer(
      "Example: shapegauge compare results/shrec11-table2 --measures FT,DCG\n"
      "         shapegauge compare mine.npy theirs.npy --labels test.cla");
  const auto arguments = std::make_shared<CompareArguments>();
  command
      ->add_option("inputs", arguments->inputs,
                   "Result folders of 'run' or tables of 'evaluate --per-query'; with --labels or --qrels: distances, "
                   "features or ranked lists")
      ->required();
  add_evaluation_options(*command, arguments->evaluation);
  add_comparison_options(*command, *arguments);
  add_resampling_options(*command, arguments->resampling);
  command->callback([command, arguments, &status] {
    arguments->of_distances = used_options(*command, options_of_distances);
    with_threads(arguments->evaluation.threads, [&] { status = run(*arguments); });
  });
}

}  // namespace shapegauge
