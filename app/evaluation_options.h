#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluation_input.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/evaluation.h"

namespace CLI {
class App;
}

namespace shapegauge {

/// The options that `evaluate` and `compare` share, as they are given.
struct EvaluationArguments {
  EvaluationFiles files;
  std::string order = "natural";
  std::string protocol = "psb";
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

/// Adds the options that say what a matrix means and how it is judged.
void add_evaluation_options(CLI::App& command, EvaluationArguments& arguments);

/// Adds --confidence, --blocks, --resamples and --seed.
void add_resampling_options(CLI::App& command, ResamplingArguments& arguments);

/// The settings of the evaluation that the arguments ask for. Throws InputError for a measure that is not known.
EvaluationOptions evaluation_options(const EvaluationArguments& arguments);

/// A matrix, or lists, with everything that belongs to it, what it is worth, and what a user should know of it.
struct EvaluatedMatrix {
  EvaluationInput input;
  Evaluation evaluation;
  std::vector<std::string> notes;  ///< in words, a sentence each
};

/// Reads the file at the path, checks and evaluates it. Throws InputError where it cannot be evaluated.
EvaluatedMatrix evaluate_file(const std::filesystem::path& path, const EvaluationArguments& arguments);

/// How many queries ties could change, in words; nothing where they could change none.
std::vector<std::string> notes_of_ties(const Evaluation& evaluation);

/// Prints notes on standard error, a line each. Called when all else has gone well: an error comes alone.
void tell(std::span<const std::string> notes);

}  // namespace shapegauge
