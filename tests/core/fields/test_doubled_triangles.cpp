// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/fields/bilateral.h"
#include "shapegauge/core/fields/centricity.h"
#include "shapegauge/core/fields/geodesics.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/doubled_shapes.h"
#include "tests/support/test_shapes.h"

// Duplicate triangles do not change fields, and each has the value of the first of its set.

namespace shapegauge {

namespace {

/// Rounding of sums may differ when samples of weight 0 are included.
constexpr double rounding = 1e-12;

/// Largest difference between values; 0 where both are missing.
double largest_difference(const Eigen::VectorXd& found, const Eigen::VectorXd& expected) {
  if (found.size() != expected.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    if (std::isnan(found[i]) && std::isnan(expected[i])) continue;
    const double difference = std::abs(found[i] - expected[i]);
    largest = std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(largest, difference);
  }
  return largest;
}

using test::for_each_variant_with_duplicates;

TEST(DoubledTriangles, DoNotChangeGeodesicDistances) {
  const auto distances = [](const Shape& mesh) -> Eigen::VectorXd { return geodesic_distances(mesh)(3); };
  for_each_variant_with_duplicates(
      distances, [&](const Eigen::VectorXd& expected, const test::ShapeWithDuplicates& doubled) {
        EXPECT_EQ(largest_difference(distances(doubled.shape), expected(doubled.vertices)), 0);
      });
}

TEST(DoubledTriangles, DoNotChangeHeatAndExactGeodesicDistances) {
  const Shape torus = test::torus(1, 0.35, 8, 12);
  for (const GeodesicMethod method : {GeodesicMethod::heat, GeodesicMethod::exact}) {
    const Eigen::VectorXd expected = geodesic_distances(torus, {.method = method})(3);
    for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(torus)) {
      SCOPED_TRACE(doubled.name);
      EXPECT_EQ(
          largest_difference(geodesic_distances(doubled.shape, {.method = method})(3), expected(doubled.vertices)), 0);
    }
  }
}

TEST(DoubledTriangles, DoNotChangeCentricity) {
  const auto values = [](const Shape& mesh) {
    return centricity(mesh, sample_shape(mesh, SampleSite::faces), {.sources = 12});
  };
  for_each_variant_with_duplicates(values,
                                   [&](const Eigen::VectorXd& expected, const test::ShapeWithDuplicates& doubled) {
                                     EXPECT_TRUE(values(doubled.shape).isApprox(expected(doubled.triangles), rounding));
                                   });
}

TEST(DoubledTriangles, DoNotChangeTheLaplacian) {
  for_each_variant_with_duplicates(
      cotangent_laplacian, [](const Laplacian& expected, const test::ShapeWithDuplicates& doubled) {
        const Laplacian found = cotangent_laplacian(doubled.shape);
        EXPECT_TRUE(found.mass == expected.mass);
        EXPECT_EQ((found.stiffness - expected.stiffness).norm(), 0);
        for (std::size_t v = 0; v < found.node_of.size(); ++v) {
          EXPECT_EQ(found.node_of[v], expected.node_of[static_cast<std::size_t>(doubled.vertices[v])]);
        }
      });
}

TEST(DoubledTriangles, DoNotChangeHeatKernels) {
  const auto heat = [](const Shape& mesh) {
    return heat_kernel_signature(laplacian_spectrum(mesh, 12), surface_area(mesh), 0.05);
  };
  for_each_variant_with_duplicates(
      heat, [&](const Eigen::VectorXd& expected, const test::ShapeWithDuplicates& doubled) {
        EXPECT_LT(largest_difference(heat(doubled.shape), expected(doubled.vertices)), rounding);
      });
}

TEST(DoubledTriangles, HaveTheSmoothedValueOfTheirFirstCopy) {
  const auto smooth = [](const Shape& mesh) {
    const Samples samples = sample_shape(mesh, SampleSite::faces);
    const Eigen::VectorXd values = (3 * samples.points.col(0) + 5 * samples.points.col(1)).array().sin();
    return bilateral_smoothing(mesh, samples, {values, samples.weights}, {.iterations = 2, .spatial_width = 0.04})
        .values;
  };
  for_each_variant_with_duplicates(smooth,
                                   [&](const Eigen::VectorXd& expected, const test::ShapeWithDuplicates& doubled) {
                                     EXPECT_TRUE(smooth(doubled.shape).isApprox(expected(doubled.triangles), rounding));
                                   });
}

}  // namespace

}  // namespace shapegauge
