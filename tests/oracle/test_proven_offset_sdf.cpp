#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "tests/core/sdf/crevice_shapes.h"
#include "tests/oracle/offset_sdf_reference.h"
#include "tests/oracle/proven_offset_sdf.h"
#include "tests/oracle/raised_samples.h"

namespace shapegauge {
namespace {

class ProvenOffsetSdfAgainstReference : public testing::TestWithParam<test::OffsetCase> {};

TEST_P(ProvenOffsetSdfAgainstReference, KeepsTheStatedTolerances) {
  const Shape& shape = GetParam().shape;
  const double r = GetParam().offset;
  const OffsetSdfReference reference(shape, r);
  ProvenOffsetSdf proven(shape, r);
  const test::RaisedSamples raised_samples(shape, r);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  for (Eigen::Index i = 0; i < samples.points.rows(); i += 19) {
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d normal = samples.normals.row(i);
    const Eigen::Vector3d nearest = proven.nearest(p, normal);
    EXPECT_NEAR(reference.distance(nearest), r, 1e-3 * r) << i;
    EXPECT_TRUE(reference.is_exterior(nearest)) << i;
    EXPECT_NEAR((nearest - p).norm(), reference.distance_to_exterior(p), 1e-2 * r) << i;
    const auto raised = raised_samples.of(p, normal, [&](const Eigen::Vector3d& x) { return reference.distance(x); });
    const Eigen::Vector3d q = proven.q(p, normal, raised);
    const bool is_direct = std::min((q - p - r * normal).norm(), (q - p + r * normal).norm()) < 1e-9;
    if (!is_direct) {
      EXPECT_NEAR(std::min((q - raised[0]).norm(), (q - raised[1]).norm()), reference.distance_from_raised(raised),
                  1.2e-2 * r)
          << i;
    }

    const Eigen::Vector3d direction = (p - q).normalized();
    const double exit = proven.exit(p, direction);
    const Eigen::Vector3d end = p + exit * direction;
    EXPECT_NEAR(reference.distance(end), r, 1e-3 * r) << i;
    EXPECT_TRUE(reference.is_exterior(end, 1 - 1e-3) || !reference.is_resolved(end)) << i;
    // No exit is skipped: the first one of a slightly larger offset does not come before.
    EXPECT_LE(exit, reference.exit(p, direction, 1 + 1e-3) + 1e-3 * r) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ProvenOffsetSdfAgainstReference, testing::ValuesIn(test::offset_cases()),
                         test::name_of_case);

}  // namespace
}  // namespace shapegauge
