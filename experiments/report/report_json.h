#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "shapegauge/experiments/report/report.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Non-negative numbers in two bytes each: {"scale", "values"}, where the value is scale * n / 65534 for each
/// little-endian n in the base64 text, and 65535 stands for infinity and for no value. Scale is the largest finite
/// value, or 1.
nlohmann::ordered_json packed(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The most cells along a side of the report's picture of a distance matrix.
inline constexpr Eigen::Index largest_heat_map = 1000;

/// The models' indices, class by class, in the models' order within a class: the order of the picture's rows.
std::vector<Eigen::Index> order_by_class(std::span<const int> labels);

/// A distance matrix as a picture, its rows and columns in order_by_class(): {"side", "block", "symmetric", "scale",
/// "values"}, the last two as packed(). A cell is the mean of a block x block part of the matrix, of its finite entries
/// (block is 1 up to largest_heat_map models). Of a symmetric matrix, row i has the cells from column i on. The
/// diagonal of single models is shown as 0, as it plays no part.
nlohmann::ordered_json heat_map(const DistanceTable& distances, std::span<const int> labels);

/// The most models for each of which the report says its nearest ones; of larger data sets it does so for the worst
/// queries only.
inline constexpr std::size_t most_models_with_neighbours = 2000;

/// The report as the data that the page's scripts read (experiments/report/page/): what `report` holds, the nearest
/// models, confusion matrices and worst queries that are found from it, and the program's version. No times, no paths.
nlohmann::ordered_json report_json(const Report& report);

}  // namespace shapegauge
