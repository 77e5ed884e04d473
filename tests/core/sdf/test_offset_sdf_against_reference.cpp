// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/offset/offset_solver.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/core/sdf/crevice_shapes.h"
#include "tests/oracle/offset_sdf_reference.h"
#include "tests/oracle/raised_samples.h"

namespace shapegauge {
namespace {

class OffsetSdfAgainstReference : public testing::TestWithParam<test::OffsetCase> {};

/// What docs/methods/offset_sdf.md#guarantees states of an accuracy, in parts of r.
struct Stated {
  OffsetAccuracy accuracy;
  double cell;          ///< h
  double distance;      ///< of q from the surface
  double passing;       ///< |p'q|, of 98 % of the samples
  double passing_most;  ///< of all
};

/// What the reference says of every 19th face, the same for all accuracies.
struct Known {
  Known(const Shape& shape, double offset)
      : r(offset), reference(shape, r), samples(sample_shape(shape, SampleSite::faces)) {
    const test::RaisedSamples all(shape, r);
    for (Eigen::Index i = 0; i < samples.points.rows(); i += step) {
      raised.push_back(all.of(samples.points.row(i), samples.normals.row(i),
                              [&](const Eigen::Vector3d& x) { return reference.distance(x); }));
      nearest.push_back(reference.distance_from_raised(raised.back()));
    }
  }

  static constexpr Eigen::Index step = 19;
  double r;
  OffsetSdfReference reference;
  Samples samples;
  std::vector<std::array<Eigen::Vector3d, 2>> raised;  ///< p', on either side
  std::vector<double> nearest;                         ///< |p'q|
};

void expect_tolerances(const Shape& shape, const Known& known, const Stated& stated) {
  const double r = known.r;
  const OffsetSdfReference& reference = known.reference;
  const Samples& samples = known.samples;
  const OffsetSdfResult result = offset_sdf(shape, samples, {.offset = r, .accuracy = stated.accuracy});
  const UnitFrame frame = unit_frame(shape);
  const Points points = (samples.points.rowwise() - frame.centre.transpose()) / frame.diagonal;
  const OffsetResults results = solve_on_grid(in_unit_frame(shape, frame), points, samples.normals,
                                              {.offset = r, .cells_per_offset = 1 / stated.cell});
  ASSERT_EQ(result.values, results.values * frame.diagonal);
  int count = 0;
  int off = 0;
  int skipped = 0;
  for (std::size_t k = 0; k < known.nearest.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k) * Known::step;
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d normal = samples.normals.row(i);
    const Eigen::Vector3d outward = result.normals.row(i);
    const double height = results.heights[i] * frame.diagonal;
    const Eigen::Vector3d q = p + height * outward;
    EXPECT_NEAR(reference.distance(q), r, stated.distance * r) << i;
    const auto& [above, below] = known.raised[k];
    const double found = std::min((q - above).norm(), (q - below).norm());
    // No exterior point is nearer to p than r: q needs no search where it is that far along the normal.
    const bool is_direct = outward.cross(normal).norm() < 1e-9 && height < 1.05 * r;
    const double error = std::abs(is_direct ? height - r : found - known.nearest[k]) / r;
    EXPECT_LE(error, stated.passing_most) << i;
    ++count;
    off += error > stated.passing + stated.distance + 4e-3 ? 1 : 0;  // 0.004 r are the reference's

    const double exit = result.values[i] + 2 * r - height;
    const Eigen::Vector3d end = p - exit * outward;
    EXPECT_NEAR(reference.distance(end), r, stated.distance * r) << i;
    EXPECT_TRUE(reference.is_exterior(end, 1 - stated.distance) || !reference.is_resolved(end)) << i;
    // No exit is skipped that is wide enough for the grid: that of an offset larger by half a cell's diagonal does not
    // come before. Nor are many others.
    const double tolerance = stated.distance * r;
    EXPECT_LE(exit, reference.exit(p, -outward, 1 + std::sqrt(0.75) * stated.cell) + tolerance) << i;
    skipped += exit > reference.exit(p, -outward, 1.01) + tolerance ? 1 : 0;
  }
  EXPECT_LE(off, count / 100);
  EXPECT_LE(skipped, 2 + count / 100);
}

void expect_tolerances(const Shape& shape, double offset) {
  const Known known(shape, offset);
  for (const Stated& stated : {Stated{OffsetAccuracy::fast, 1 / 2.5, 0.04, 0.02, 0.2},
                               {OffsetAccuracy::standard, 1 / 3.0, 0.02, 0.01, 0.1},
                               {OffsetAccuracy::fine, 1 / 5.0, 0.01, 0.01, 0.1}}) {
    SCOPED_TRACE(to_parameter_value(stated.accuracy));
    expect_tolerances(shape, known, stated);
  }
}

TEST_P(OffsetSdfAgainstReference, MatchesTheReferenceImplementationWithinDocumentedTolerances) {
  expect_tolerances(GetParam().shape, GetParam().offset);
}

INSTANTIATE_TEST_SUITE_P(Shapes, OffsetSdfAgainstReference, testing::ValuesIn(test::offset_cases()),
                         test::name_of_case);

TEST(OffsetSdfOfScansAgainstReference, MatchesTheReferenceImplementationWithinDocumentedTolerances) {
  const char* const data = std::getenv("SHAPEGAUGE_DATA");
  if (data == nullptr) GTEST_SKIP() << "SHAPEGAUGE_DATA names no folder with real meshes";
  for (const char* const name : {"T0.off", "T200.off", "T380.off", "T540.off"}) {
    SCOPED_TRACE(name);
    const Shape scan = read_shape(std::filesystem::path(data) / "shrec11_nonrigid" / name);
    expect_tolerances(test::of_diagonal_1(decimate(scan, 400)), 0.05);
  }
}

}  // namespace
}  // namespace shapegauge
