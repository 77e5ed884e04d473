#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// Non-negative numbers as {"scale", "values"}: packed_values() from 0 to the scale, which is the largest finite value,
/// or 1.
nlohmann::ordered_json packed_numbers(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The picture of a distance matrix: {"side", "block", "symmetric", "scale", "values"}, the last two as
/// packed_numbers(). Of a symmetric picture, row i has the cells from column i on.
nlohmann::ordered_json heat_map(const DistanceOverview& distances);

/// The most models for each of which the report says its nearest ones; of larger data sets it does so for the worst
/// queries only.
inline constexpr std::size_t most_models_with_neighbours = 2000;

/// The report as the data that the page's scripts read (pages/report/): what `report` holds, the nearest
/// models, confusion matrices and worst queries that are found from it, and the program's version. No times, no paths.
nlohmann::ordered_json report_json(const Report& report);

}  // namespace shapegauge
