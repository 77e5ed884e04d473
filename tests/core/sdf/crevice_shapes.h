// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

#include "tests/support/test_shapes.h"

/// Shapes with crevices and valleys, small enough for OffsetSdfReference.
namespace shapegauge::test {

/// A shape with a diagonal of 1, and an offset.
struct OffsetCase {
  std::string name;
  Shape shape;
  double offset;
};

inline void PrintTo(const OffsetCase& one, std::ostream* stream) { *stream << one.name << ", offset " << one.offset; }

/// Four capsules from one centre, with crevices between them.
inline Shape star() {
  std::vector<Shape> arms;
  for (unsigned i = 0; i < 4; ++i) {
    arms.push_back(transformed(capsule(0.18, 1, 8, 3), 1, rotation(i), 0.3 * Eigen::Vector3d(i & 1U, i & 2U, 0)));
  }
  return joined(arms);
}

/// Two walls that face each other, joined at one end.
inline Shape clamp() {
  Shape upper = box({2, 1, 0.2}, 2);
  upper.vertices.col(2).array() += 0.45;
  Shape end = box({0.2, 1, 0.65}, 2);
  end.vertices.col(2).array() += 0.225;
  end.vertices.col(0).array() -= 0.95;
  return joined({box({2, 1, 0.2}, 2), upper, end});
}

/// Turned, so that nothing is parallel to a grid, with a bounding box whose diagonal is 1 then.
inline Shape of_diagonal_1(const Shape& shape) {
  const Shape turned = transformed(shape, 1, rotation(5), Eigen::Vector3d::Zero());
  return transformed(turned, 1 / bounding_box_diagonal(turned), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
}

inline std::vector<OffsetCase> offset_cases() {
  std::vector<OffsetCase> result;
  for (const double offset : {0.05, 0.1}) {
    result.push_back({"torus", of_diagonal_1(torus(1, 0.45, 14, 9)), offset});
    result.push_back({"star", of_diagonal_1(star()), offset});
    result.push_back({"clamp", of_diagonal_1(clamp()), offset});
    result.push_back({"sphere", of_diagonal_1(sphere(1, 1)), offset});
  }
  return result;
}

inline std::string name_of_case(const testing::TestParamInfo<OffsetCase>& one) {
  return one.param.name + std::to_string(std::lround(1000 * one.param.offset));
}

}  // namespace shapegauge::test
