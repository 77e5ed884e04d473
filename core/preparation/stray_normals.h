// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Returns true if the normals of a cloud are not those of its surface but other vectors from a file: more than
/// a quarter of them make an angle of more than 60 degrees with the lines of unsigned_point_normals(). Directions that
/// are independent of the surface do so at half of the points, and the surface's normals at up to 17 % (measured on
/// coarse and noisy samplings). False for a mesh, without normals, and for a cloud so noisy or coarse that the
/// estimated lines of nearest neighbours disagree (mean absolute cosine below 0.8).
bool has_stray_normals(const Shape& shape);

/// Removes normals that are not those of the surface (has_stray_normals()). Returns true if it removed them.
bool remove_stray_normals(Shape& shape);

/// Warning for users, to be shown if remove_stray_normals() has removed the normals of a cloud.
inline constexpr std::string_view stray_normals_warning =
    "the normals of the points are ignored, since they are not those of the surface: more than a quarter of them "
    "differ "
    "by more than 60 degrees from those of the planes through neighbouring points";

}  // namespace shapegauge
