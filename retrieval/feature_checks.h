// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shapegauge/core/base/distance_rows.h"

namespace shapegauge {

/// Checks a table of features, one row per model, none of them NaN. Returns a warning, as a sentence, if the single
/// precision of Signatures makes distinct rows equal or changes their differences notably. Throws InputError for a
/// matrix of distances (three or more rows, square, symmetric, with a zero diagonal), for features beyond the range of
/// single precision, and, in tables of ten or more rows and two or more columns, for a column of row numbers (0, 1, 2,
/// ... or 1, 2, 3, ...).
std::optional<std::string> check_features(const DistanceMatrix& features);

}  // namespace shapegauge
