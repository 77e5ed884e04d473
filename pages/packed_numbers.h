// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

/// Encoding of numbers in HTML pages: base64 of little-endian integers of one or two bytes. pages/common/packed.mjs
/// decodes them.

namespace shapegauge {

inline constexpr int no_level = 65535;          ///< two-byte level that represents a missing value
inline constexpr int top_level = 65534;         ///< maximum two-byte level of a value; the minimum level is 0
inline constexpr int coordinate_level = 65535;  ///< maximum two-byte level of a coordinate; the minimum level is 0
inline constexpr int direction_levels = 127;    ///< one-byte level of the coordinate 1 of a unit vector; -127 for -1

/// Appends the two bytes of a number from 0 to 65,535, little-endian.
void append_short(std::string& bytes, long number);

/// Encodes numbers from 0 to 65,535 as two bytes each, in base64.
std::string packed_shorts(const std::vector<std::int32_t>& numbers);

/// Quantises values from `low` to `low + width` to levels from 0 to top_level and encodes these in base64. Values that
/// are not finite become no_level.
std::string packed_values(const Eigen::Ref<const Eigen::VectorXd>& values, double low, double width);

}  // namespace shapegauge
