// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/offset/offset_solver.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/core/sdf/crevice_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(OffsetSolver, ResultsDependNeitherOnTheOrderOfSamplesNorOnThreads) {
  const Shape shape = test::of_diagonal_1(test::star());
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const OffsetResults forward = solve_on_grid(shape, samples.points, samples.normals, {.parallel = false});
  const OffsetResults backward =
      solve_on_grid(shape, samples.points.colwise().reverse(), samples.normals.colwise().reverse(), {.parallel = true});
  EXPECT_EQ(forward.values, backward.values.reverse());
  EXPECT_EQ(forward.directions, backward.directions.colwise().reverse());
}

TEST(OffsetSolver, ResultOfASampleDoesNotDependOnOtherSamples) {
  // Shapes on which samples of one block have both sides covered, and sites near and far.
  for (const test::OffsetCase& one : test::offset_cases()) {
    const Samples samples = sample_shape(one.shape, SampleSite::faces);
    const OffsetSolverOptions options{.offset = one.offset, .parallel = false};
    const OffsetResults all = solve_on_grid(one.shape, samples.points, samples.normals, options);
    std::vector<std::int32_t> few;
    for (Eigen::Index f = 0; f < samples.points.rows(); f += 7) few.push_back(static_cast<std::int32_t>(f));
    const OffsetResults alone =
        solve_on_grid(one.shape, samples.points(few, Eigen::all), samples.normals(few, Eigen::all), options, few);
    EXPECT_EQ(alone.values, all.values(few)) << one.name;
    EXPECT_EQ(alone.directions, all.directions(few, Eigen::all)) << one.name;
    for (std::size_t i = 0; i < few.size(); ++i) {
      ASSERT_EQ(alone.outcomes[i], all.outcomes[static_cast<std::size_t>(few[i])]) << one.name << ' ' << few[i];
    }
  }
}

TEST(OffsetSolver, ChoosesTheSideOfTheNormalIfBothSidesAreEquallyNear) {
  // Both sides of an open sheet are exterior and equally near.
  const Shape sheet{.vertices = Points{{0, 0, 0}, {0.7, 0, 0}, {0.7, 0.7, 0}, {0, 0.7, 0}},
                    .triangles = Triangles{{0, 1, 2}, {0, 2, 3}}};
  const Samples samples = sample_shape(sheet, SampleSite::faces);
  const OffsetResults up = solve_on_grid(sheet, samples.points, samples.normals, {});
  const OffsetResults down = solve_on_grid(sheet, samples.points, -samples.normals, {});
  EXPECT_TRUE(up.directions.isApprox(samples.normals));
  EXPECT_TRUE(down.directions.isApprox(-samples.normals));
  EXPECT_LT(up.values.maxCoeff(), 2e-3 * 0.05);
}

TEST(OffsetSolver, ReportsPointsOffTheSurfaceAsMissing) {
  const Shape sphere = test::of_diagonal_1(test::sphere(1, 2));
  Points points(4, 3);
  points << 0, 0, 0, 9, 9, 9, std::nan(""), 0, 0, sphere.vertices.row(0);
  Points normals = Points::Zero(4, 3);
  const OffsetResults results = solve_on_grid(sphere, points, normals, {});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(results.outcomes[i], OffsetOutcome::missing) << i;
    EXPECT_TRUE(std::isnan(results.values[static_cast<Eigen::Index>(i)])) << i;
  }
  EXPECT_EQ(results.outcomes[3], OffsetOutcome::searched);
  EXPECT_NEAR(results.values[3], 2 * sphere.vertices.row(0).norm(), 0.02);
}

TEST(OffsetSolver, SolvesSamplesOnTrianglesOmittedFromTheGrid) {
  // 327,680 triangles, of which less than a tenth are used for an offset of 10 %.
  const Shape sphere = test::of_diagonal_1(test::sphere(1, 7));
  const Samples samples = sample_surface(sphere, 2000);
  const OffsetResults results = solve_on_grid(sphere, samples.points, samples.normals, {.offset = 0.1});
  EXPECT_EQ(results.values,
            solve_on_grid(sphere, samples.points, samples.normals, {.offset = 0.1}, samples.triangles).values);
  const double diameter = 2 * sphere.vertices.row(0).norm();
  for (std::size_t i = 0; i < results.outcomes.size(); ++i) {
    ASSERT_EQ(results.outcomes[i], OffsetOutcome::direct) << i;
    EXPECT_NEAR(results.values[static_cast<Eigen::Index>(i)], diameter, 0.01 * 0.1) << i;
  }
}

TEST(OffsetSolver, ResultsHardlyChangeUnderRotation) {
  // Intersecting arms: p + r n is covered near their joints.
  const double r = 0.05;
  const Shape arms = test::of_diagonal_1(
      test::joined({test::capsule(0.2, 2, 32, 12),
                    test::transformed(test::capsule(0.2, 1.5, 32, 12), 1, test::rotation(3), {0.1, 0.2, 0.3})}));
  const auto results_of = [&](const Shape& shape) {
    const Samples samples = sample_shape(shape, SampleSite::faces);
    return solve_on_grid(shape, samples.points, samples.normals, {.offset = r});
  };
  const OffsetResults results = results_of(arms);
  const OffsetResults turned = results_of(test::transformed(arms, 1, test::rotation(7), {0.1, 0.2, 0.3}));
  EXPECT_GT(std::count(results.outcomes.begin(), results.outcomes.end(), OffsetOutcome::searched), 200);
  const auto off = ((results.values - turned.values).array().abs() > 0.01 * r).count();
  EXPECT_LE(off, results.values.size() / 50);
}

}  // namespace
}  // namespace shapegauge
