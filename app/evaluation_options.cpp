#include "app/evaluation_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/evaluation/evaluate_input.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

namespace {

std::vector<std::string> notes_of(const EvaluatedMatrix& evaluated, const MatrixFindings& findings,
                                  const EvaluationArguments& arguments) {
  std::vector<std::string> notes = evaluated.input.notes;
  std::ranges::move(matrix_warnings(findings, evaluated.input.query_ids, arguments.files.similarity),
                    std::back_inserter(notes));
  if (evaluated.evaluation.models_left_out > 0) {
    notes.push_back(fmt::format("{} models are never queries, as their classes have fewer than {} models",
                                evaluated.evaluation.models_left_out, arguments.minimum_class_size));
  }
  return notes;
}

void add_input_options(CLI::App& command, EvaluationArguments& arguments) {
  EvaluationFiles& files = arguments.files;
  command.add_option("--labels", files.labels,
                     "Classes of the models: .cla, .csv (id,class and if you like split) or a folder of class folders");
  command.add_option("--targets", files.targets, "Classes of the models to be found, where --labels is of the queries");
  command.add_option("--qrels", files.qrels, "TREC judgements in place of --labels");
  command
      .add_option("--level", files.level, "Level of the .cla hierarchy: 1 the roots, 2 their children; 0 the classes")
      ->capture_default_str();
  command.add_option("--ids", files.ids, "Ids of the rows, one a line");
  command
      .add_option("--order", arguments.order,
                  "Which model a row is where no ids say so: the i-th in natural order, or in the classification's")
      ->check(CLI::IsMember({"natural", "classification"}))
      ->capture_default_str();
  CLI::Option* similarity = command.add_flag("--similarity", files.similarity, "The matrix is of similarities");
  command.add_option("--distance", files.distance, "The file holds features, a row a model: the distance between them")
      ->check(CLI::IsMember(distance_names()))
      ->excludes(similarity);
}

}  // namespace

void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments) {
  add_input_options(command, arguments);
  command.add_option("--protocol", arguments.protocol, "Evaluation protocol")
      ->check(CLI::IsMember(protocol_names()))
      ->capture_default_str();
  command.add_option("--ties", arguments.ties, "Order of models at equal distance; expected: the mean over all orders")
      ->check(CLI::IsMember(ties_names()))
      ->capture_default_str();
  command.add_option("--measures", arguments.measures, "Measures, as in NN,FT,P@10 (default: the protocol's own)")
      ->delimiter(',');
  command.add_option("--min-class-size", arguments.minimum_class_size, "Models of smaller classes are never queries")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
}

void add_resampling_options(CLI::App& command, ResamplingArguments& arguments) {
  command.add_option("--confidence", arguments.confidence, "Confidence of the intervals, as in 0.95")
      ->check(CLI::Range(0.5, 0.9999));
  command
      .add_option("--blocks", arguments.blocks, "What is resampled as a whole: classes, or queries as if independent")
      ->check(CLI::IsMember(blocks_names()))
      ->capture_default_str();
  command.add_option("--resamples", arguments.resampling.resamples, "Number of resamples")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  command.add_option("--seed", arguments.resampling.seed, "Seed of the resamples")->capture_default_str();
}

EvaluationOptions evaluation_options(const EvaluationArguments& arguments) {
  EvaluationOptions options;
  options.protocol = protocol_of(arguments.protocol).value();
  options.ties = ties_of(arguments.ties).value();
  options.minimum_class_size = arguments.minimum_class_size;
  if (!arguments.curve.empty()) options.curve = curve_kind_of(arguments.curve);
  try {
    options.measures = measures_of(arguments.measures);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("--measures: {}; see 'shapegauge measures'", error.what()));
  }
  return options;
}

EvaluatedMatrix evaluate_file(const std::filesystem::path& path, const EvaluationArguments& arguments) {
  const EvaluationOptions options = evaluation_options(arguments);
  EvaluationFiles files = arguments.files;
  files.matrix = path;
  files.classification_order = arguments.order == "classification";
  EvaluatedMatrix evaluated{.input = read_evaluation_input(files), .evaluation = {}, .notes = {}};
  try {
    CheckedEvaluation checked = evaluate_and_check(evaluated.input, options);
    evaluated.evaluation = std::move(checked.evaluation);
    evaluated.notes = notes_of(evaluated, checked.findings, arguments);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
  return evaluated;
}

std::vector<std::string> notes_of_ties(const Evaluation& evaluation) {
  if (evaluation.queries_with_ties == 0) return {};
  return {fmt::format(
      "the answers to {} of {} queries have relevant and other models at equal distance; they are ordered by --ties {}",
      evaluation.queries_with_ties, evaluation.queries.size(), name_of(evaluation.ties))};
}

void tell(std::span<const std::string> notes) {
  for (const std::string& note : notes) fmt::print(stderr, "shapegauge: note: {}\n", note);
}

}  // namespace shapegauge
