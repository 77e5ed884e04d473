// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// Encodes non-negative numbers as {"scale", "values"}: packed_values() from 0 to the scale, which is the largest
/// finite number, or 1 if none is positive.
nlohmann::ordered_json packed_numbers(const Eigen::Ref<const Eigen::VectorXd>& values);

/// Encodes the heat map of a distance matrix: {"side", "block", "symmetric", "scale", "values"}. It has `side` rows of
/// cells of `block` x `block` models, with values as in packed_numbers(). If symmetric, row i begins at column i.
nlohmann::ordered_json heat_map(const DistanceOverview& distances);

/// Maximum number of models for which the report lists the nearest ones of each; for larger data sets it does so for
/// the worst queries only.
inline constexpr std::size_t max_models_with_neighbours = 2000;

/// Encodes the report for the page's scripts (pages/report/): the contents of `report`, the nearest models, confusion
/// matrices and worst queries computed from it, and the program's version. Contains no times and no paths.
nlohmann::ordered_json report_json(const Report& report);

}  // namespace shapegauge
