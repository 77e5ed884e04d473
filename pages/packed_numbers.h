#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

/// Numbers of pages in base64: integers of two bytes, little-endian, or of one. pages/common/packed.mjs reads them.

namespace shapegauge {

inline constexpr int no_level = 65535;          ///< stands for no value
inline constexpr int top_level = 65534;         ///< of a value; the least one is 0
inline constexpr int coordinate_level = 65535;  ///< of a coordinate
inline constexpr int direction_levels = 127;    ///< of a unit vector's coordinate, either way

/// Appends the two bytes of a number from 0 to 65,535.
void append_short(std::string& bytes, long number);

/// Numbers from 0 to 65,535 in base64.
std::string packed_shorts(const std::vector<std::int32_t>& numbers);

/// Values from `low` to `low + width` in base64, in 65,535 steps; those that are not finite as no_level.
std::string packed_values(const Eigen::Ref<const Eigen::VectorXd>& values, double low, double width);

}  // namespace shapegauge
