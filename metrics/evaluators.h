// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Score that an evaluation program prints.
struct EvaluatorScore {
  std::string quantity;  ///< what it is called in tables, equal for scores that are compared: "FT"
  std::string measure;   ///< name of a measure, or of a definition of the program: "shrec21.FT"
};

/// Evaluation program of a benchmark, a contest or a library: which definitions, cutoffs, denominators and rule of ties
/// it uses.
struct Evaluator {
  std::string name;
  std::string program;     ///< which program it reproduces
  std::string deviations;  ///< from the definitions of the measures, and other conventions
  Protocol protocol = Protocol::psb;
  CurveKind curve = CurveKind::psb;
  int minimum_class_size = 2;
  bool finds_itself = false;  ///< see EvaluationOptions
  std::vector<EvaluatorScore> scores;
};

/// Returns all evaluators. Ties are in the order of the models: Ties::index.
std::span<const Evaluator> evaluators();

/// Returns the names of all evaluators.
std::vector<std::string> evaluator_names();

/// Returns the options of an evaluation as by the evaluator of that name. Throws ArgumentError for an unknown name.
EvaluationOptions options_of_evaluator(std::string_view name);

}  // namespace shapegauge
