#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "shapegauge/metrics/distance_table.h"

namespace shapegauge {

/// The most cells along a side of the report's picture of a distance matrix.
inline constexpr Eigen::Index largest_heat_map = 1000;

/// The models' indices, class by class, in the models' order within a class: the order of the picture's rows.
std::vector<Eigen::Index> order_by_class(std::span<const int> labels);

/// A distance matrix as a picture, its rows and columns in order_by_class(): {"side", "block", "symmetric", "scale",
/// "values"}, the last two as packed(). A cell is the mean of a block x block part of the matrix, of its finite entries
/// (block is 1 up to largest_heat_map models). Of a symmetric matrix, row i has the cells from column i on. The
/// diagonal of single models is shown as 0, as it plays no part.
nlohmann::ordered_json heat_map(const DistanceTable& distances, std::span<const int> labels);

}  // namespace shapegauge
