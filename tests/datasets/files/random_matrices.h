// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Square matrices of 1 to 12 rows with entries of all magnitudes, exactly representable as float32, including
/// infinity but not NaN.
rc::Gen<DistanceMatrix> square_matrices();

}  // namespace shapegauge
