#pragma once

#include <optional>
#include <string>

#include "shapegauge/core/base/distance_rows.h"

namespace shapegauge {

/// Returns a warning, as a sentence, if distinct rows of features become equal in the single precision of Signatures.
/// `features` are not NaN.
std::optional<std::string> feature_precision_warning(const DistanceMatrix& features);

}  // namespace shapegauge
