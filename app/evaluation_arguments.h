// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
  std::string evaluator;
  std::string missing_queries = std::string(word_of(Unanswered::left_out));
  int threads = 0;
  std::string ties = name_of(EvaluationOptions{}.ties);
  std::string curve;
  std::vector<std::string> measures;
  int minimum_class_size = EvaluationOptions{}.minimum_class_size;
};

/// Options that describe files of distances and labels or how they are evaluated, and act on nothing else.
inline constexpr std::array<std::string_view, 15> options_of_distances{
    "--evaluator",       "--variable",    "--labels",        "--targets",    "--shared-ids", "--qrels",
    "--level",           "--ids",         "--order",         "--similarity", "--distance",   "--ties",
    "--missing-queries", "--all-queries", "--min-class-size"};

/// Returns which of the options were given.
std::vector<std::string> given_options(const CLI::App& command, std::span<const std::string_view> options);

/// Options of resampling, as given.
struct ResamplingArguments {
  std::string blocks = "classes";
  double confidence = 0;
  ResamplingOptions resampling;
};

/// Format of printed scores, as given.
struct ScoreFormat {
  std::string format = "table";
  bool fractions = false;  ///< instead of percent
  std::optional<int> digits = {};
};

/// Adds --format, described as given, --fractions and --digits.
void add_score_format_options(CLI::App& command, ScoreFormat& arguments, const std::string& description);

/// Returns the style of scores in tables. Default: 2 decimal places, or 4 for csv; 2 more for fractions.
ScoreStyle style_of(const ScoreFormat& arguments);

/// Adds the options for labels and evaluation, and --threads. `missing_queries` are the values of --missing-queries,
/// the default first.
void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments,
                            const std::vector<std::string>& missing_queries = list_of_words<Unanswered>());

/// Adds the options that describe files of distances and labels.
void add_file_options(CLI::App& command, EvaluationArguments& arguments);

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
