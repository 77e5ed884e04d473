#pragma once

#include <cstdint>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// So many points at random on the surface of a mesh, every place equally likely.
Shape random_points(const Shape& mesh, Eigen::Index count, std::uint64_t seed);

}  // namespace shapegauge::test
