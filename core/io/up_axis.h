// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Axis that points up in pictures and 3D views; `automatic` depends on the file (up_direction()).
enum class UpAxis { automatic, x, y, z, minus_x, minus_y, minus_z };
template <>
inline constexpr std::array<std::string_view, 7> words_of<UpAxis>{"auto", "x", "y", "z", "-x", "-y", "-z"};

/// Returns the description of the setting `up`, whose value is a word of UpAxis.
Parameter up_parameter();

/// Beginning of the comment by which a shape's text file states its vertical axis; a word of UpAxis follows. Written as
/// the last line, which simple readers do not reach.
inline constexpr std::string_view up_comment = "# up: ";

/// Returns the comment of a file that states its vertical axis (up_comment), without the line end, to copy it to
/// another file; empty if there is none.
std::string read_up_comment(const std::filesystem::path& file);

/// Returns the unit vector of the axis. `automatic` is the axis that a comment in the last 256 bytes of the file
/// states, as in generated shapes, otherwise the convention of its format (ShapeFormat::y_is_up), by the extension.
/// Without a known extension, for example for standard input, it is z.
Eigen::Vector3d up_direction(UpAxis axis, const std::filesystem::path& file);

}  // namespace shapegauge
