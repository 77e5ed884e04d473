#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/evaluation.h"

namespace CLI {
class App;
}

namespace shapegauge {

/// Options shared by `evaluate`, `compare` and `leaderboard`, as given.
struct EvaluationArguments {
  EvaluationFiles files;
  std::string order;
  std::string protocol;
  std::string missing_queries;
  int threads = 0;
  std::string ties = name_of(EvaluationOptions{}.ties);
  std::string curve;
  std::vector<std::string> measures;
  int minimum_class_size = EvaluationOptions{}.minimum_class_size;
};

/// Options of resampling, as given.
struct ResamplingArguments {
  std::string blocks = "classes";
  double confidence = 0;
  ResamplingOptions resampling;
};

/// Format of printed scores, as given.
struct ScoreFormat {
  std::string format = "table";
  std::string unit = "percent";
  std::optional<int> digits = {};
};

/// Adds --format, described as given, --unit and --digits.
void add_score_format_options(CLI::App& command, ScoreFormat& arguments, const std::string& description);

/// Returns the style of scores in tables. Default: 2 decimal places, or 4 for csv; 2 more for fractions.
ScoreStyle style_of(const ScoreFormat& arguments);

/// Adds the options for labels and evaluation, and --threads. `missing_queries` are the values of --missing-queries,
/// the default first.
void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments,
                            const std::vector<std::string>& missing_queries = list_of_words<Unanswered>());

/// Adds --confidence, --blocks, --resamples and --seed.
void add_resampling_options(CLI::App& command, ResamplingArguments& arguments);

/// Returns the protocol of the arguments; by default psb, or trec with judgements.
Protocol chosen_protocol(const EvaluationArguments& arguments);

/// Returns the evaluation options of the arguments. Throws InputError for an unknown measure.
EvaluationOptions evaluation_options(const EvaluationArguments& arguments);

/// Returns the files of the evaluation and their interpretation, without the matrix.
EvaluationFiles files_as_given(const EvaluationArguments& arguments);

/// Returns the files of classes, judgements and ids, for check_output_files(); files that are not given are empty.
std::vector<std::filesystem::path> label_files(const EvaluationArguments& arguments);

/// Evaluates the matrix, or the ranked lists, at the path, with a progress line on the terminal.
EvaluatedFiles evaluate_with_progress(const std::filesystem::path& path, const EvaluationArguments& arguments);

/// Prints each warning as a line on standard error. Called after everything else succeeded: an error is printed alone.
void print_warnings(std::span<const std::string> warnings);

}  // namespace shapegauge
