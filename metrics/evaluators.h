// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Score that an evaluation program prints, and the measure that reproduces it.
struct EvaluatorScore {
  std::string quantity;  ///< label in tables, such as "FT"; scores with the same label are compared
  std::string measure;   ///< measure that computes the score: "FT", or a definition of this program, "shrec21.FT"
};

/// Conventions of the evaluation program of a benchmark, a contest or a library: definitions of scores, cutoffs,
/// denominators and order of ties.
struct Evaluator {
  std::string name;                    ///< name in options and tables, such as "psb_table"
  std::string program;                 ///< name and version of the evaluation program
  std::string deviations;              ///< text: deviations from the definitions of the measures, and other conventions
  Protocol protocol = Protocol::psb;   ///< protocol that the program follows
  CurveKind curve = CurveKind::psb;    ///< kind of the program's precision-recall curve
  int minimum_class_size = 2;          ///< minimum number of models in the class of a query (EvaluationOptions)
  bool finds_itself = false;           ///< true: the query itself is ranked in its list (EvaluationOptions)
  std::vector<EvaluatorScore> scores;  ///< scores that the program prints
};

/// Returns all evaluators. Each ranks models at equal distance by index (Ties::index).
std::span<const Evaluator> evaluators();

/// Returns the names of all evaluators.
std::vector<std::string> evaluator_names();

/// Returns the evaluation options that reproduce the evaluator with this name. Throws ArgumentError for an unknown
/// name.
EvaluationOptions options_of_evaluator(std::string_view name);

}  // namespace shapegauge
