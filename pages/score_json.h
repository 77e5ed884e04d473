// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/metrics/evaluation.h"

/// Scores as JSON for the scripts of pages.

namespace shapegauge {

/// Number of significant digits of scores on pages.
inline constexpr int score_digits = 6;

/// Encodes scores as a JSON array, rounded to score_digits.
nlohmann::ordered_json rounded_scores(const Eigen::Ref<const Eigen::VectorXd>& scores);

/// Encodes a matrix of scores as a JSON array of its rows, with scores rounded to score_digits.
nlohmann::ordered_json rounded_rows(const Eigen::MatrixXd& scores);

/// Encodes the scores of an evaluation that pages draw: averages, scores per class and precision-recall curves.
nlohmann::ordered_json chart_data_json(const Evaluation& evaluation);

/// Encodes a table, cell by cell, for the function textTable() of the pages' scripts.
nlohmann::ordered_json table_json(const TextTable& table);

}  // namespace shapegauge
