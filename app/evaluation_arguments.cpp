#include "app/evaluation_arguments.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>

#include "app/options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

namespace {

void add_input_options(CLI::App& command, EvaluationArguments& arguments) {
  EvaluationFiles& files = arguments.files;
  command.add_option(
      "--labels", files.labels,
      "Classes of the models: .cla, a table (id,class and if you like split), a list with a class a line, "
      "a .npy of whole numbers, or a folder of class folders");
  command.add_option("--targets", files.targets, "Classes of the models to be found, where --labels is of the queries");
  command.add_option("--qrels", files.qrels, "TREC judgements in place of --labels");
  command
      .add_option("--level", files.level, "Level of the .cla hierarchy: 1 the roots, 2 their children; 0 the classes")
      ->capture_default_str();
  command.add_option("--ids", files.ids, "Ids of the rows, one a line");
  command
      .add_option("--order", arguments.order,
                  "Which model a row is where no ids say so: the i-th in natural order, or of the labels' file "
                  "(default: of the file where it is a list, else natural)")
      ->check(CLI::IsMember({"natural", "file", "classification"}));
  CLI::Option* similarity = command.add_flag("--similarity", files.similarity, "The matrix is of similarities");
  command
      .add_option("--distance", files.distance,
                  "The file holds features, a row a model: the distance between them, or the descriptor whose they are")
      ->check(CLI::IsMember(feature_distance_names()))
      ->excludes(similarity);
}

}  // namespace

void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments) {
  add_input_options(command, arguments);
  command.add_option("--protocol", arguments.protocol, "Evaluation protocol (default: psb, with --qrels trec)")
      ->check(CLI::IsMember(protocol_names()));
  CLI::Option* missing =
      command
          .add_option("--missing-queries", arguments.missing_queries,
                      "Queries without a ranked list: skip leaves them out, zero counts them with scores of 0")
          ->check(CLI::IsMember({"skip", "zero"}))
          ->capture_default_str();
  command
      .add_flag_callback(
          "-c,--all-queries", [&arguments] { arguments.missing_queries = "zero"; },
          "Same as --missing-queries zero, as with trec_eval -c")
      ->excludes(missing);
  command.add_option("--ties", arguments.ties, "Order of models at equal distance; expected: the mean over all orders")
      ->check(CLI::IsMember(ties_names()))
      ->capture_default_str();
  command.add_option("--measures", arguments.measures, "Measures, as in NN,FT,P@10 (default: the protocol's own)")
      ->delimiter(',');
  command.add_option("--min-class-size", arguments.minimum_class_size, "Models of smaller classes are never queries")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  add_threads_option(command, arguments.threads);
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
  add_seed_option(command, arguments.resampling.seed);
}

Protocol chosen_protocol(const EvaluationArguments& arguments) {
  if (!arguments.protocol.empty()) return protocol_of(arguments.protocol).value();
  return arguments.files.qrels.empty() ? Protocol::psb : Protocol::trec;
}

EvaluationOptions evaluation_options(const EvaluationArguments& arguments) {
  EvaluationOptions options;
  options.protocol = chosen_protocol(arguments);
  options.ties = ties_of(arguments.ties).value();
  options.minimum_class_size = arguments.minimum_class_size;
  if (!arguments.curve.empty()) options.curve = curve_kind_of(arguments.curve);
  try {
    options.measures = measures_of(arguments.measures);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("--measures: {}; see 'shapegauge measures'", error.what()));
  }
  return options;
}

EvaluationFiles files_as_given(const EvaluationArguments& arguments) {
  EvaluationFiles files = arguments.files;
  if (arguments.order == "natural") files.order = RowOrder::natural;
  if (arguments.order == "file" || arguments.order == "classification") files.order = RowOrder::file;
  if (arguments.missing_queries == "zero") files.unanswered = Unanswered::count;
  return files;
}

EvaluatedFiles evaluate_with_progress(const std::filesystem::path& path, const EvaluationArguments& arguments) {
  EvaluationFiles files = files_as_given(arguments);
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
