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
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/method_comparison_tables.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::vector<fs::path> inputs;
  EvaluationArguments evaluation;
  ResamplingArguments resampling{.blocks = "classes", .confidence = 0.95, .resampling = {}};
  std::string test = "randomization";
  std::string average = "micro";
  std::string reference;
  std::vector<std::string> names;
  std::string format = "table";
  std::string unit = "percent";
  int digits = 2;
};

// The methods of a table, under one protocol: the only one that there is, else the one asked for.
std::vector<MethodScores> methods_of_table(const fs::path& path, const CompareArguments& arguments) {
  const std::string wanted_protocol = name_of(chosen_protocol(arguments.evaluation));
  std::vector<MethodScores> methods = read_method_scores(path);
  const bool one =
      std::ranges::all_of(methods, [&](const MethodScores& method) { return method.protocol == methods[0].protocol; });
  if (one) return methods;
  std::erase_if(methods, [&](const MethodScores& method) { return method.protocol != wanted_protocol; });
  if (methods.empty()) {
    throw InputError(fmt::format("{}: no scores under the protocol {}; choose another with --protocol", path.string(),
                                 wanted_protocol));
  }
  return methods;
}

// The methods of one input; what a user should know of it is added to the warnings.
std::vector<MethodScores> methods_of(const fs::path& path, const CompareArguments& arguments,
                                     std::vector<std::string>& warnings) {
  if (is_folder(path)) return methods_of_table(path / "per_query.csv", arguments);
  const bool matrix = !arguments.evaluation.files.labels.empty() || !arguments.evaluation.files.qrels.empty();
  if (!matrix) return methods_of_table(path, arguments);
  const EvaluatedFiles evaluated = evaluate_with_progress(path, arguments.evaluation);
  for (const std::string& warning : evaluated.warnings) {
    warnings.push_back(fmt::format("{}: {}", path.string(), warning));
  }
  if (const auto tied = ties_warning(evaluated.evaluation, evaluated.findings)) {
    warnings.push_back(fmt::format("{}: {}", path.string(), *tied));
  }
  return {method_scores(method_name(path, evaluated.data), path.string(), evaluated.data.task, evaluated.evaluation)};
}

ComparisonOptions options_of(const CompareArguments& arguments, const std::vector<std::string>& methods) {
  ComparisonOptions options;
  options.test = pair_test_of(arguments.test).value();
  options.blocks = blocks_of(arguments.resampling.blocks).value();
  options.average = average_of(arguments.average).value();
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

std::string explanation(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                        const ComparisonOptions& options) {
  return fmt::format(
      "{} queries of {}, protocol {}, {} averages, {:g} % intervals and tests over {}.\n"
      "A letter behind a score: significantly better than that method ({} test, Holm's correction, p <= {:g}).\n",
      methods.classes.size(), fmt::format("{} {}", comparisons[0].units, name_of(options.blocks)), methods.protocol,
      name_of(options.average), 100 * options.confidence, name_of(options.blocks), name_of(options.test),
      1 - options.confidence);
}

std::string formatted_comparison(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                                 const ComparisonOptions& options, const CompareArguments& arguments) {
  const ScoreStyle style{.percent = arguments.unit == "percent", .decimals = arguments.digits};
  if (arguments.format == "json") return comparison_json(methods, comparisons, options).dump(2) + "\n";
  const bool csv = arguments.format == "csv";
  const Table pairs = pairs_table(methods, comparisons, style, csv);
  if (csv) return to_csv(pairs);
  const Table summary = comparison_summary(methods, comparisons, options, style);
  const std::string words = explanation(methods, comparisons, options);
  if (arguments.format == "latex") return to_latex(summary);
  if (arguments.format == "markdown") return to_markdown(summary) + "\n" + words + "\n" + to_markdown(pairs);
  return to_plain_text(summary) + "\n" + words + "\n" + to_plain_text(pairs);
}

void warn_of_same_files(std::span<const fs::path> inputs, std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code unknown;
      if (!fs::equivalent(inputs[j], inputs[i], unknown)) continue;
      warnings.push_back(fmt::format("{} and {} are the same file", inputs[j].string(), inputs[i].string()));
    }
  }
}

int run(const CompareArguments& arguments) {
  std::vector<MethodScores> methods;
  std::vector<std::string> warnings;
  for (const fs::path& input : arguments.inputs) {
    std::vector<MethodScores> more = methods_of(input, arguments, warnings);
    std::ranges::move(more, std::back_inserter(methods));
  }
  const AlignedMethods aligned = align_methods(methods, arguments.evaluation.measures, arguments.names);
  const ComparisonOptions options = options_of(arguments, aligned.methods);
  std::vector<MethodComparison> comparisons;
  {
    const BusyLine line("comparing the methods");
    for (const Eigen::MatrixXd& values : aligned.values) {
      comparisons.push_back(compare_methods(values, aligned.classes, options));
    }
  }
  warn_of_same_files(arguments.inputs, warnings);
  if (const auto few = few_units_warning(comparisons.front(), options, Audience::command_line)) {
    warnings.push_back(*few);
  }
  print_output("{}", formatted_comparison(aligned, comparisons, options, arguments));
  print_warnings(warnings);
  return exit_success;
}

void add_comparison_options(CLI::App& command, CompareArguments& arguments) {
  command.add_option("--test", arguments.test, "Test of a pair")
      ->check(CLI::IsMember(pair_test_names()))
      ->capture_default_str();
  command.add_option("--average", arguments.average, "Average that is compared: over queries, or over classes")
      ->check(CLI::IsMember(average_names()))
      ->capture_default_str();
  command.add_option("--reference", arguments.reference,
                     "Compare this method with each other one (default: all pairs)");
  command.add_option("--names", arguments.names, "Names of the methods, in their order, as in ours,theirs")
      ->delimiter(',');
  command.add_option("--format", arguments.format, "Format of the result; csv has the pairs, latex the methods")
      ->check(CLI::IsMember({"table", "csv", "json", "markdown", "latex"}))
      ->capture_default_str();
  command.add_option("--unit", arguments.unit, "Unit of the figures in tables; JSON is always in fractions")
      ->check(CLI::IsMember({"percent", "fraction"}))
      ->capture_default_str();
  command.add_option("--digits", arguments.digits, "Digits behind the point in tables")
      ->check(CLI::Range(0, 15))
      ->capture_default_str();
}

}  // namespace

void add_compare_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("compare", "Compare methods on the same queries: intervals, tests, wins");
  command->footer(
      "Example: shapegauge compare results/shrec11-table2 --measures FT,DCG\n"
      "         shapegauge compare mine.npy theirs.npy --labels test.cla\n"
      "An input is the folder of a run (all its methods), a table of 'evaluate --per-query', or, with --labels or\n"
      "--qrels, whatever 'evaluate' takes.");
  const auto arguments = std::make_shared<CompareArguments>();
  command->add_option("inputs", arguments->inputs, "Results, or with --labels or --qrels distances")->required();
  add_evaluation_options(*command, arguments->evaluation);
  add_comparison_options(*command, *arguments);
  add_resampling_options(*command, arguments->resampling);
  command->callback(
      [arguments, &status] { with_threads(arguments->evaluation.threads, [&] { status = run(*arguments); }); });
}

}  // namespace shapegauge
