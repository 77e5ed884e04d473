#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/pages/html_page.h"

/// Scores as the scripts of pages read them.

namespace shapegauge {

/// Significant digits of scores on pages.
inline constexpr int score_digits = 6;

/// The scores as an array, rounded.
template <typename Values>
nlohmann::ordered_json rounded_scores(const Values& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const double value : values) json.push_back(rounded_to_digits(value, score_digits));
  return json;
}

/// The rows of a table of scores, rounded.
nlohmann::ordered_json rounded_rows(const Eigen::MatrixXd& scores);

/// What the charts of averages, classes and precision-recall curves read of an evaluation.
nlohmann::ordered_json charted_json(const Evaluation& evaluation);

}  // namespace shapegauge
