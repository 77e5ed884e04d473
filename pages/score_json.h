// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/metrics/evaluation.h"

/// Scores as the scripts of pages read them.

namespace shapegauge {

/// Significant digits of scores on pages.
inline constexpr int score_digits = 6;

/// The scores as an array, rounded.
nlohmann::ordered_json rounded_scores(const Eigen::Ref<const Eigen::VectorXd>& scores);

/// The rows of a table of scores, rounded.
nlohmann::ordered_json rounded_rows(const Eigen::MatrixXd& scores);

/// What the charts of averages, classes and precision-recall curves read of an evaluation.
nlohmann::ordered_json charted_json(const Evaluation& evaluation);

/// Encodes the cells of a table for textTable() of the pages' scripts.
nlohmann::ordered_json table_json(const TextTable& table);

}  // namespace shapegauge
