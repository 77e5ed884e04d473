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

/// Axis that points up in pictures and 3D views.
enum class UpAxis { automatic, x, y, z, minus_x, minus_y, minus_z };
template <>
inline constexpr std::array<std::string_view, 7> words_of<UpAxis>{"auto", "x", "y", "z", "-x", "-y", "-z"};

/// Returns the parameter `up`, a word of UpAxis.
Parameter up_parameter();

/// Comment by which a text file states its axis, before a word of UpAxis. At the end, simple readers do not meet it.
inline constexpr std::string_view up_comment = "# up: ";

/// Returns that comment of a file with the axis, as a line without its end, to be written again; empty without one.
std::string stated_up(const std::filesystem::path& file);

/// Returns the direction of the axis. `automatic` is the axis that a comment in the last 256 bytes of the file states,
/// as in generated shapes, otherwise the convention of its format (ShapeFormat::y_is_up), by the extension. Without a
/// known extension, for example for standard input, it is z.
Eigen::Vector3d up_direction(UpAxis axis, const std::filesystem::path& file);

}  // namespace shapegauge
