// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

/// Numbers of pages in base64: integers of two bytes, little-endian, or of one. Decoded by pages/common/packed.mjs.

namespace shapegauge {

inline constexpr int no_level = 65535;          ///< represents a missing value
inline constexpr int top_level = 65534;         ///< maximum level of a value; the minimum is 0
inline constexpr int coordinate_level = 65535;  ///< maximum level of a coordinate
inline constexpr int direction_levels = 127;    ///< levels of a unit vector's coordinate in either direction

/// Appends the two bytes of a number from 0 to 65,535.
void append_short(std::string& bytes, long number);

/// Encodes numbers from 0 to 65,535 in base64.
std::string packed_shorts(const std::vector<std::int32_t>& numbers);

/// Encodes values from `low` to `low + width` in base64, in 65,535 steps; values that are not finite become no_level.
std::string packed_values(const Eigen::Ref<const Eigen::VectorXd>& values, double low, double width);

}  // namespace shapegauge
