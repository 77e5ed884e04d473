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
                     "Classes of the models: a .cla file, a table (id,class), a list (one class per line, or .npy), or "
                     "a folder with one folder per class");
  command.add_option(
      "--targets", files.targets,
      "File with the classes of the targets (columns), if these differ from the queries (rows) of --labels");
  command.add_flag("--shared-ids", files.shared_ids,
                   "Treat a query and a target with equal ids as one model, removed from its own list");
  command.add_option("--qrels", files.qrels, "File of TREC relevance judgements (qrels), instead of --labels");
  command
      .add_option("--level", files.level,
                  "Level of the .cla hierarchy to evaluate. 1: roots; 2: their children; 0: the models' own classes")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command.add_option("--variable", files.variable, "Name of the array in an .npz or .mat file (default: its only one)");
  command.add_option("--ids", files.ids, "File with the model ids of the rows, one per line, for a matrix without ids");
  command
      .add_option("--order", arguments.order,
                  "Order of the models in the rows of a matrix without ids. natural: by id, 2 before 10; file: as in "
                  "the --labels file (default: file if it has one class per line, otherwise natural)")
      ->check(one_of({"natural", "file"}))
      ->transform([](const std::string& word) { return word == "classification" ? "file" : word; });  // the older word
  CLI::Option* similarity =
      command.add_flag("--similarity", files.similarity, "Read the matrix as similarities: larger is more similar");
  command
      .add_option("--distance", files.distance,
                  "Distance between rows of features; a descriptor's name selects its own distance")
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
          .add_option(
              "--evaluator", arguments.evaluator,
              "Evaluation program to reproduce, with its protocol and measures; 'shapegauge measures' describes them")
          ->check(one_of(evaluator_names()));
  command
      .add_option("--protocol", arguments.protocol,
                  "Protocol. psb: the query is removed from its own list; paper: it counts as the first hit; trec: "
                  "like psb, with measures of text retrieval (default: psb, or trec with --qrels)")
      ->check(one_of(list_of_words<Protocol>()))
      ->excludes(evaluator);
  CLI::Option* missing = command
                             .add_option("--missing-queries", arguments.missing_queries,
                                         "Queries without a ranked list are omitted (skip) or score 0 (zero)")
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
                  "Order of models at equal distance: by index; relevant first (optimistic) or last (pessimistic); "
                  "mean over all orders (expected)")
      ->check(one_of(list_of_words<Ties>()))
      ->capture_default_str()
      ->excludes(evaluator);
  command
      .add_option("--measures", arguments.measures,
                  "Measures to compute, such as NN,FT,P@10; 'shapegauge measures' lists them (default: those of the "
                  "protocol)")
      ->delimiter(',')
      ->excludes(evaluator);
  command
      .add_option("--min-class-size", arguments.minimum_class_size,
                  "Minimum number of models in the class of a query, the query included; other queries are omitted")
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
                   "Print scores as fractions from 0 to 1 instead of percent; JSON always has fractions");
  const auto set_unit = [&arguments](const std::string& unit) { arguments.fractions = unit == "fraction"; };
  command.add_option_function<std::string>("--unit", set_unit)
      ->check(one_of({"percent", "fraction"}))
      ->group(hidden_options);
  command
      .add_option("--digits", arguments.digits,
                  "Number of decimal places in tables (default: 2, or 4 for csv; 2 more with --fractions)")
      ->check(CLI::Range(0, 15));
}

ScoreStyle style_of(const ScoreFormat& arguments) {
  const bool percent = !arguments.fractions;
  const int usual = (arguments.format == "csv" ? 4 : 2) + (percent ? 0 : 2);
  return {.percent = percent, .decimals = arguments.digits.value_or(usual)};
}

void add_resampling_options(CLI::App& command, ResamplingArguments& arguments) {
  begin_option_group(command, "Statistics");
  command
      .add_option("--confidence", arguments.confidence,
                  "Confidence level of intervals, and 1 - significance level of tests (default: 0.95; evaluate prints "
                  "intervals only with this option)")
      ->check(within<double>(confidence_bounds));
  command
      .add_option("--blocks", arguments.blocks,
                  "Unit of resampling: queries (results hold for other queries of these classes) or classes (also for "
                  "other classes)")
      ->check(one_of(list_of_words<ResamplingUnit>()))
      ->capture_default_str();
  command
      .add_option("--resamples", arguments.resampling.resamples,
                  "Number of random resamples for confidence intervals and significance tests; more resamples are more "
                  "precise, but slower")
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
