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

/// Values of the options that `evaluate`, `compare` and `leaderboard` share, as given on the command line.
struct EvaluationArguments {
  EvaluationFiles files;  ///< input files, such as --labels and --qrels, and how they are read
  std::string order;      ///< order of matrix rows without ids: "natural" or "file"; empty for the default
  std::string protocol;   ///< protocol: "psb", "paper" or "trec"; empty for the default (chosen_protocol())
  std::string evaluator;  ///< name of an evaluation program to reproduce, such as "trec_eval"; empty for none
  std::string missing_queries = std::string(word_of(Unanswered::left_out));  ///< unanswered queries: "skip" or "zero"
  int threads = 0;                                                           ///< number of threads; 0 for all cores
  std::string ties = name_of(EvaluationOptions{}.ties);                      ///< order of ties, such as "expected"
  std::string curve;                  ///< kind of precision-recall curve, such as "psb"; empty for that of the protocol
  std::vector<std::string> measures;  ///< names of measures, such as "P@10"; empty for those of the protocol
  int minimum_class_size = EvaluationOptions{}.minimum_class_size;  ///< minimum number of models in a query's class
};

/// Names of the options that only affect how distances and labels are read from files and evaluated. Commands reject
/// them for other inputs.
inline constexpr std::array<std::string_view, 15> options_of_distances{
    "--evaluator",       "--variable",    "--labels",        "--targets",    "--shared-ids", "--qrels",
    "--level",           "--ids",         "--order",         "--similarity", "--distance",   "--ties",
    "--missing-queries", "--all-queries", "--min-class-size"};

/// Returns those of the named `options` that were given on the command line, to report that they do not apply.
std::vector<std::string> used_options(const CLI::App& command, std::span<const std::string_view> options);

/// Values of the options of resampling, as given on the command line.
struct ResamplingArguments {
  std::string blocks = "classes";  ///< unit of resampling: "queries" or "classes" (ResamplingUnit)
  double confidence = 0;           ///< confidence level of intervals; 0 for no intervals
  ResamplingOptions resampling;    ///< number of resamples, and seed of the random numbers
};

/// Values of the options for the format of printed scores, as given on the command line.
struct ScoreFormat {
  std::string format = "table";    ///< "table", "csv", "markdown", "latex" (TableFormat) or "json"
  bool fractions = false;          ///< true to print fractions instead of percent
  std::optional<int> digits = {};  ///< number of decimal places in tables; absent for the default (style_of())
};

/// Adds the options --format (with `description` as its help text), --fractions and --digits.
void add_score_format_options(CLI::App& command, ScoreFormat& arguments, const std::string& description);

/// Returns the number format of scores in tables: percent or fractions, and the number of decimal places. Default: 2
/// decimal places, or 4 for csv; 2 more for fractions.
ScoreStyle style_of(const ScoreFormat& arguments);

/// Adds the options for labels and evaluation, and --threads. `missing_queries` lists the valid values of
/// --missing-queries, the default first.
void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments,
                            const std::vector<std::string>& missing_queries = list_of_words<Unanswered>());

/// Adds the options that describe files of distances and labels.
void add_file_options(CLI::App& command, EvaluationArguments& arguments);

/// Adds the options of resampling: --confidence, --blocks, --resamples and --seed.
void add_resampling_options(CLI::App& command, ResamplingArguments& arguments);

/// Returns the evaluation protocol of the arguments. Default: psb, or trec with TREC relevance judgements.
Protocol chosen_protocol(const EvaluationArguments& arguments);

/// Returns the evaluation options of the arguments. Throws InputError for an unknown measure.
EvaluationOptions evaluation_options(const EvaluationArguments& arguments);

/// Returns the input files of an evaluation and how they are read, from the arguments. The path of the matrix, which is
/// not an option, stays empty.
EvaluationFiles evaluation_files(const EvaluationArguments& arguments);

/// Returns the paths of the files of class labels, relevance judgements and ids, as inputs for check_output_files(); a
/// path is empty if the option was not given.
std::vector<std::filesystem::path> label_files(const EvaluationArguments& arguments);

/// Evaluates the distance matrix or the ranked lists at `path`, with a progress line on the terminal.
EvaluatedFiles evaluate_with_progress(const std::filesystem::path& path, const EvaluationArguments& arguments);

/// Prints each warning as a line on standard error. Call after everything else succeeded: an error is printed without
/// warnings.
void print_warnings(std::span<const std::string> warnings);

}  // namespace shapegauge
