// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/evaluation_arguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/evaluators.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

void add_file_options(CLI::App& command, EvaluationArguments& arguments) {
  EvaluationFiles& files = arguments.files;
  begin_option_group(command, input_options);
  command.add_option("--labels", files.labels,
                     "Classes of the models: .cla file, table (id,class), list (one class per line, or .npy) or folder "
                     "with one subfolder per class");
  command.add_option("--targets", files.targets,
                     "Classes of the targets (columns), as --labels; --labels then has the queries (rows) only");
  command.add_flag("--shared-ids", files.shared_ids,
                   "Treat equal ids in --labels and --targets as one model, removed from its own list");
  command.add_option("--qrels", files.qrels, "File of TREC relevance judgements, instead of --labels");
  command
      .add_option("--level", files.level,
                  "Level of the .cla hierarchy to evaluate. 1: roots; 2: their children; 0: the models' own classes")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command.add_option("--variable", files.variable, "Array name in .npz and .mat files (default: the only array)");
  command.add_option("--ids", files.ids, "File of model ids, one line per row of a matrix without ids");
  command
      .add_option("--order", arguments.order,
                  "Order of the models in a matrix without ids. natural: by id, 2 before 10; file: as in --labels "
                  "(default: natural; file if --labels is a list)")
      ->check(one_of({"natural", "file"}))
      ->transform([](const std::string& word) { return word == "classification" ? "file" : word; });  // the older word
  CLI::Option* similarity = command.add_flag("--similarity", files.similarity,
                                             "Read similarities instead of distances: larger is more similar");
  command
      .add_option(
          "--distance", files.distance,
          "Distance between rows of features, required to read features; a descriptor's name, such as d2, selects "
          "its own distance")
      ->check(one_of(feature_distance_names()))
      ->excludes(similarity);
}

void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments,
                            const std::vector<std::string>& missing_queries) {
  arguments.missing_queries = missing_queries.front();
  add_file_options(command, arguments);
  begin_option_group(command, "Evaluation");
  CLI::Option* evaluator =
      command
          .add_option("--evaluator", arguments.evaluator,
                      "Evaluation program to reproduce, with its protocol and measures; see 'shapegauge measures'")
          ->check(one_of(evaluator_names()));
  command
      .add_option(
          "--protocol", arguments.protocol,
          "Evaluation protocol. psb: the query is removed from its list; paper: the query is the first hit; trec: "
          "like psb, with text-retrieval measures (default: psb; trec with --qrels)")
      ->check(one_of(list_of_words<Protocol>()))
      ->excludes(evaluator);
  CLI::Option* missing = command
                             .add_option("--missing-queries", arguments.missing_queries,
                                         "Queries without a ranked list: omit (skip) or score 0 (zero)")
                             ->check(one_of(missing_queries))
                             ->capture_default_str();
  command
      .add_flag_callback(
          "-c,--all-queries", [&arguments] { arguments.missing_queries = word_of(Unanswered::count); },
          "Like --missing-queries zero, as trec_eval -c")
      ->excludes(missing)
      ->group(hidden_options);
  command
      .add_option("--ties", arguments.ties,
                  "Order of models at equal distance. index: lower index first; optimistic: relevant first; "
                  "pessimistic: relevant last; expected: mean over all orders")
      ->check(one_of(list_of_words<Ties>()))
      ->capture_default_str()
      ->excludes(evaluator);
  command
      .add_option("--measures", arguments.measures,
                  "Measures to compute, such as NN,FT,P@10; see 'shapegauge measures' (default: the protocol's)")
      ->delimiter(',')
      ->excludes(evaluator);
  command
      .add_option("--min-class-size", arguments.minimum_class_size,
                  "Minimum class size, query included; queries of smaller classes are omitted")
      ->check(within<int>(parameter_named("minimum_class_size", evaluation_table).bounds))
      ->capture_default_str()
      ->excludes(evaluator);
  add_threads_option(command, arguments.threads);
}

std::vector<std::string> used_options(const CLI::App& command, std::span<const std::string_view> options) {
  std::vector<std::string> used;
  for (const std::string_view option : options) {
    if (command.get_option(std::string(option))->count() > 0) used.emplace_back(option);
  }
  return used;
}

void add_score_format_options(CLI::App& command, ScoreFormat& arguments, const std::string& description) {
  add_format_option(command, arguments.format, description);
  command.add_flag("--fractions", arguments.fractions,
                   "Print scores as fractions instead of percent; json always has fractions");
  const auto set_unit = [&arguments](const std::string& unit) { arguments.fractions = unit == "fraction"; };
  command.add_option_function<std::string>("--unit", set_unit)
      ->check(one_of({"percent", "fraction"}))
      ->group(hidden_options);
  command
      .add_option("--digits", arguments.digits,
                  "Decimal places in tables (default: 2, or 4 for csv; 2 more with --fractions)")
      ->check(CLI::Range(0, 15));
}

ScoreStyle style_of(const ScoreFormat& arguments) {
  const bool percent = !arguments.fractions;
  const int default_decimals = (arguments.format == "csv" ? 4 : 2) + (percent ? 0 : 2);
  return {.percent = percent, .decimals = arguments.digits.value_or(default_decimals)};
}

void add_resampling_options(CLI::App& command, ResamplingArguments& arguments) {
  begin_option_group(command, "Statistics");
  command
      .add_option("--confidence", arguments.confidence,
                  "Confidence level of intervals, and 1 - significance level of tests (default: 0.95; for evaluate, no "
                  "intervals)")
      ->check(within<double>(confidence_bounds));
  command
      .add_option("--blocks", arguments.blocks,
                  "Unit of resampling. queries: results generalise to new queries of these classes; classes: also to "
                  "new classes")
      ->check(one_of(list_of_words<ResamplingUnit>()))
      ->capture_default_str();
  command
      .add_option("--resamples", arguments.resampling.resamples,
                  "Number of resamples for confidence intervals and tests; a larger number is more precise, but slower")
      ->check(within<int>(parameter_named("resamples", resampling_table).bounds))
      ->capture_default_str();
  add_seed_option(command, arguments.resampling.seed);
}

Protocol chosen_protocol(const EvaluationArguments& arguments) {
  if (!arguments.evaluator.empty()) return options_of_evaluator(arguments.evaluator).protocol;
  if (!arguments.protocol.empty()) return value_of_word<Protocol>(arguments.protocol).value();
  return arguments.files.qrels.empty() ? Protocol::psb : Protocol::trec;
}

EvaluationOptions evaluation_options(const EvaluationArguments& arguments) {
  EvaluationOptions options;
  if (!arguments.evaluator.empty()) {
    options = options_of_evaluator(arguments.evaluator);
    if (!arguments.curve.empty()) options.curve = value_of_word<CurveKind>(arguments.curve);
    return options;
  }
  options.protocol = chosen_protocol(arguments);
  options.ties = value_of_word<Ties>(arguments.ties).value();
  options.minimum_class_size = arguments.minimum_class_size;
  if (!arguments.curve.empty()) options.curve = value_of_word<CurveKind>(arguments.curve);
  try {
    options.measures = measures_of(arguments.measures);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("--measures: {}; see 'shapegauge measures'", error.what()));
  }
  return options;
}

EvaluationFiles evaluation_files(const EvaluationArguments& arguments) {
  EvaluationFiles files = arguments.files;
  if (arguments.order == "natural") files.order = RowOrder::natural;
  if (arguments.order == "file") files.order = RowOrder::file;
  files.unanswered = value_of_word<Unanswered>(arguments.missing_queries).value();
  return files;
}

std::vector<std::filesystem::path> label_files(const EvaluationArguments& arguments) {
  const EvaluationFiles& files = arguments.files;
  return {files.labels, files.targets, files.qrels, files.ids};
}

EvaluatedFiles evaluate_with_progress(const std::filesystem::path& path, const EvaluationArguments& arguments) {
  EvaluationFiles files = evaluation_files(arguments);
  files.matrix = path;
  ProgressLine line;
  return evaluate_files(files, evaluation_options(arguments), [&](Eigen::Index done, Eigen::Index rows) {
    line.show(path.filename().string(), static_cast<std::size_t>(done), static_cast<std::size_t>(rows));
  });
}

void print_warnings(std::span<const std::string> warnings) {
  for (const std::string& warning : warnings) warn(warning);
}

}  // namespace shapegauge
