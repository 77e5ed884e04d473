// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Marks the outliers of a cloud: points whose sixth neighbour is farther than 10 times the median such distance
/// (point_spacing()). None if they would be more than 1 % of the points, as in a cloud of varying density, none where
/// most points coincide with six others, and none for a mesh. Throws InputError for an unusable shape
/// (require_usable()).
std::vector<bool> outliers(const Shape& shape);

/// Returns the number of outliers().
std::size_t outlier_count(const Shape& shape);

/// Formats the number of outliers for a message: "3 of 1000 points are outliers, ...".
std::string outlier_text(std::size_t count, Eigen::Index points);

/// Returns the warning about outliers() of a shape, if it has any.
std::optional<std::string> outlier_warning(const Shape& shape);

/// Removes the outliers() of a cloud and their normals.
Shape without_outliers(Shape shape);

}  // namespace shapegauge
