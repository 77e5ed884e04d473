#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/evaluation.h"

namespace CLI {
class App;
}

namespace shapegauge {

/// The options that `evaluate` and `compare` share, as they are given.
struct EvaluationArguments {
  EvaluationFiles files;
  std::string order;
  std::string protocol;
  std::string missing_queries = "skip";
  int threads = 0;
  std::string ties = "index";
  std::string curve;
  std::vector<std::string> measures;
  int minimum_class_size = 2;
};

/// The options of resampling, as they are given.
struct ResamplingArguments {
  std::string blocks = "classes";
  double confidence = 0;
  ResamplingOptions resampling;
};

/// Adds the options that say what a matrix means and how it is judged, and --threads.
void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments);

/// Adds --confidence, --blocks, --resamples and --seed.
void add_resampling_options(CLI::App& command, ResamplingArguments& arguments);

/// The protocol that the arguments ask for: psb, or trec with judgements, where they do not say.
Protocol chosen_protocol(const EvaluationArguments& arguments);

/// The settings of the evaluation that the arguments ask for. Throws InputError for a measure that is not known.
EvaluationOptions evaluation_options(const EvaluationArguments& arguments);

/// The files, and how they are to be taken, but for the matrix.
EvaluationFiles files_as_given(const EvaluationArguments& arguments);

/// Evaluates the matrix, or the ranked lists, at the path; a line on the terminal says how far it is.
EvaluatedFiles evaluate_with_progress(const std::filesystem::path& path, const EvaluationArguments& arguments);

/// Prints a line each on standard error. Called when all else has gone well: an error comes alone.
void print_warnings(std::span<const std::string> warnings);

}  // namespace shapegauge
