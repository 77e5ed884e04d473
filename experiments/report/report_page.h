#pragma once

#include <string>

#include "shapegauge/experiments/report/report.h"

namespace shapegauge {

/// The report as one HTML file that needs nothing else: styles, scripts, data and pictures are in it. The same report
/// gives the same bytes, on any number of threads.
std::string report_page(const Report& report);

}  // namespace shapegauge
