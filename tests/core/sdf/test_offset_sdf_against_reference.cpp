#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/spatial/exterior_entry.h"
#include "shapegauge/core/spatial/nearest_exterior.h"
#include "tests/core/sdf/offset_sdf_reference.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

struct Case {
  std::string name;
  Shape shape;
  double offset;
};

void PrintTo(const Case& one, std::ostream* stream) { *stream << one.name << ", offset " << one.offset; }

/// Four capsules from one centre, with crevices between them.
Shape star() {
  std::vector<Shape> arms;
  for (unsigned i = 0; i < 4; ++i) {
    arms.push_back(test::transformed(test::capsule(0.18, 1, 8, 3), 1, test::rotation(i),
                                     0.3 * Eigen::Vector3d(i & 1U, i & 2U, 0)));
  }
  return test::joined(arms);
}

/// Two walls that face each other, joined at one end.
Shape clamp() {
  Shape upper = test::box({2, 1, 0.2}, 2);
  upper.vertices.col(2).array() += 0.45;
  Shape end = test::box({0.2, 1, 0.65}, 2);
  end.vertices.col(2).array() += 0.225;
  end.vertices.col(0).array() -= 0.95;
  return test::joined({test::box({2, 1, 0.2}, 2), upper, end});
}

std::vector<Case> cases() {
  std::vector<Case> result;
  for (const double offset : {0.05, 0.1}) {
    result.push_back({"torus", test::torus(1, 0.45, 14, 9), offset});
    result.push_back({"star", star(), offset});
    result.push_back({"clamp", clamp(), offset});
    result.push_back({"sphere", test::sphere(1, 1), offset});
  }
  return result;
}

class OffsetSdfAgainstReference : public testing::TestWithParam<Case> {};

TEST_P(OffsetSdfAgainstReference, KeepsTheStatedTolerances) {
  const Shape shape = test::transformed(GetParam().shape, 1 / bounding_box_diagonal(GetParam().shape),
                                        test::rotation(5), Eigen::Vector3d::Zero());
  const double r = GetParam().offset;
  const OffsetSdfReference reference(shape, r);
  const TriangleBVH tree(shape);
  const OffsetExterior exterior(tree, bounding_box(shape), r, is_watertight(shape));
  const Samples samples = sample_shape(shape, SampleSite::faces);
  NearestExteriorSearch search(exterior);
  ExteriorEntrySearch entry(exterior);
  for (Eigen::Index i = 0; i < samples.points.rows(); i += 19) {
    const Eigen::Vector3d p = samples.points.row(i);
    const ExteriorPoint q = search.find(p, samples.normals.row(i).transpose());
    EXPECT_NEAR(reference.distance(q.point), r, 1e-3 * r) << i;
    EXPECT_TRUE(reference.is_exterior(q.point)) << i;
    EXPECT_NEAR((q.point - p).norm(), reference.distance_to_exterior(p), 1e-2 * r) << i;

    const Eigen::Vector3d direction = (p - q.point).normalized();
    const double exit = entry.find(p, direction).distance;
    const Eigen::Vector3d end = p + exit * direction;
    EXPECT_NEAR(reference.distance(end), r, 1e-3 * r) << i;
    EXPECT_TRUE(reference.is_exterior(end, 1 - 1e-3) || !reference.is_resolved(end)) << i;
    // No exit is skipped: the first one of a slightly larger offset does not come before.
    EXPECT_LE(exit, reference.exit(p, direction, 1 + 1e-3) + 1e-3 * r) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, OffsetSdfAgainstReference, testing::ValuesIn(cases()), [](const auto& one) {
  return one.param.name + std::to_string(std::lround(1000 * one.param.offset));
});

}  // namespace
}  // namespace shapegauge
