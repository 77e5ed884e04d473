#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/experiments/report/report.h"

namespace shapegauge {

/// The most models for each of which the report says its nearest ones; of larger data sets it does so for the worst
/// queries only.
inline constexpr std::size_t most_models_with_neighbours = 2000;

/// The report as the data that the page's scripts read (experiments/report/page/): what `report` holds, the nearest
/// models, confusion matrices and worst queries that are found from it, and the program's version. No times, no paths.
nlohmann::ordered_json report_json(const Report& report);

}  // namespace shapegauge
