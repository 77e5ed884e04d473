// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Returns one flag per point of a cloud, true for outliers: points whose sixth neighbour is farther than 10 times the
/// median such distance (point_spacing()). None if they would be more than 1 % of the points, as in a cloud of varying
/// density, none where most points coincide with six others, and none for a mesh. Throws InputError for an unusable
/// shape (require_usable()).
std::vector<bool> outliers(const Shape& shape);

/// Returns the number of outliers() of a shape; 0 for a mesh.
std::size_t outlier_count(const Shape& shape);

/// Formats a message about `count` outliers in a cloud of `points` points: "3 of 1000 points are outliers, ...".
std::string outlier_text(std::size_t count, Eigen::Index points);

/// Returns a warning that a cloud has outliers(); nothing for a shape without outliers.
std::optional<std::string> outlier_warning(const Shape& shape);

/// Removes the outliers() of a cloud and their normals; returns a mesh unchanged.
Shape without_outliers(Shape shape);

}  // namespace shapegauge
