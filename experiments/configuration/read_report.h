#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"

namespace shapegauge {

/// The setting "report" of a retrieval experiment with these signatures, or what stands for its absence (null). The
/// schema holds for it. Throws MisplacedValue for pictures of a signature that is not there or has no field of its own,
/// and for a range of no width.
ReportConfiguration read_report(const nlohmann::json& setting, const std::vector<SignatureConfiguration>& signatures);

}  // namespace shapegauge
