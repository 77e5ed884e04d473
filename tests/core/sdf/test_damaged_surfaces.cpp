// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

/// Damaged meshes have the same values as intact ones.
namespace shapegauge {
namespace {

/// Fraction of values that differ by more than a fraction of r.
double fraction_differing(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double tolerance) {
  return static_cast<double>(((a - b).cwiseAbs().array() > tolerance).count()) / static_cast<double>(a.size());
}

/// A torus, whose samples are measured on it and on damaged versions of it.
class OffsetSdfOfADamagedTorus : public testing::Test {
 protected:
  /// Expects the same SDF at the torus' faces if `shape` replaces the surface.
  void expect_same_in(const Shape& shape) const {
    const OffsetSdfResult found = offset_sdf(shape, samples, {.offset = offset});
    const double r = offset * bounding_box_diagonal(torus);
    EXPECT_LE(fraction_differing(clean, found.values, 1e-2 * r), 1e-3);
    EXPECT_LE((clean - found.values).cwiseAbs().maxCoeff(), 0.1 * r);
  }

  static constexpr double offset = 0.02;
  Shape torus = test::torus(1, 0.4, 24, 48);
  Samples samples = sample_shape(torus, SampleSite::faces);
  Eigen::VectorXd clean = offset_sdf(torus, samples, {.offset = offset}).values;
};

TEST_F(OffsetSdfOfADamagedTorus, IsUnchangedByReversedFaces) {
  for (const double fraction : {0.1, 0.5, 1.0}) {
    RandomNumbers random(1);
    expect_same_in(flip_orientation(torus, fraction, random));
  }
}

TEST_F(OffsetSdfOfADamagedTorus, IsUnchangedByDuplicatedAndTwoSidedFaces) {
  Shape twice = torus;
  twice.triangles.conservativeResize(2 * torus.triangles.rows(), 3);
  twice.triangles.bottomRows(torus.triangles.rows()) = torus.triangles;
  expect_same_in(twice);
  twice.triangles.bottomRows(torus.triangles.rows()) = test::flipped(torus).triangles;
  expect_same_in(twice);
}

TEST_F(OffsetSdfOfADamagedTorus, IsUnchangedBySplitAndUnusedVertices) {
  expect_same_in(test::soup(torus));
  Shape with_others = torus;
  with_others.vertices.conservativeResize(torus.vertices.rows() + 2, 3);
  with_others.vertices.bottomRows(2) << 9, 9, 9, 0.5, 0, 0;
  expect_same_in(with_others);
}

TEST_F(OffsetSdfOfADamagedTorus, IsUnchangedBySmallSpheresInsideTheTube) {
  std::vector<Shape> parts = {torus};
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5 * i;
    const Eigen::Vector3d position(std::cos(angle), std::sin(angle), 0.1);
    // Some are oriented the other way: what they enclose, then, is a void.
    const Shape part = test::sphere(0.02 + 0.01 * (i % 6), 1);
    parts.push_back(
        test::transformed(i % 2 == 0 ? part : test::flipped(part), 1, Eigen::Matrix3d::Identity(), position));
  }
  expect_same_in(test::joined(parts));
}

}  // namespace
}  // namespace shapegauge
