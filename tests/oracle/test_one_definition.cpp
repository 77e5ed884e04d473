#include <Eigen/Geometry>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/oracle/exterior_entry.h"
#include "tests/oracle/nearest_exterior.h"
#include "tests/oracle/offset_exterior.h"
#include "tests/support/test_shapes.h"

/// The exterior is one, whether a closed surface helps to decide it or connectivity alone does
/// (docs/reference/definitions.md#offset-sdf). Of the proven search.
namespace shapegauge {
namespace {

/// At how many samples the two decisions differ about E(r) itself: about a point that either found to be the closest of
/// the exterior or its entry, or about the distance of the former by more than the 1e-2 r that either may miss.
///
/// The values alone would not say: two points of E(r), both within the tolerance of being the closest, may see quite
/// different parts of the shape.
struct Disputes {
  int missed = 0;    ///< connectivity finds less exterior
  int invented = 0;  ///< it finds more
};

Disputes disputes_about(const Shape& closed, const Samples& samples, double offset) {
  const SurfaceTree tree(closed);
  const OffsetExterior local(tree, bounding_box(closed), offset, true);
  const OffsetExterior connected(tree, bounding_box(closed), offset, false);
  NearestExteriorSearch local_search(local);
  NearestExteriorSearch connected_search(connected);
  ExteriorEntrySearch local_entry(local);
  ExteriorEntrySearch connected_entry(connected);
  Disputes disputes;
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d normal = samples.normals.row(i);
    const Eigen::Vector3d q = local_search.find(p, normal).point;
    const Eigen::Vector3d other = connected_search.find(p, normal).point;
    const Eigen::Vector3d inward = (p - q).normalized();
    const std::array found = {q, other, Eigen::Vector3d(p + local_entry.find(p, inward).distance * inward),
                              Eigen::Vector3d(p + connected_entry.find(p, inward).distance * inward)};
    const double farther = (other - p).norm() - (q - p).norm();
    bool missed = farther > 1e-2 * offset;
    bool invented = farther < -1e-2 * offset;
    for (const Eigen::Vector3d& x : found) {
      const bool is_exterior = local.contains(x) == true;
      const bool is_connected = connected.contains(x) == true;
      missed |= is_exterior && !is_connected;
      invented |= is_connected && !is_exterior;
    }
    disputes.missed += missed ? 1 : 0;
    disputes.invented += invented ? 1 : 0;
  }
  return disputes;
}

Shape random_part() {
  const double size = *rc::gen::inRange(20, 60) / 100.0;
  Shape part;
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      part = test::sphere(size, 2);
      break;
    case 1:
      part = test::capsule(size / 2, 1.5, 16, 5);
      break;
    case 2:
      part = test::box({size, 2 * size, 0.8}, 4);
      break;
    default:
      part = test::torus(1, size / 2, 12, 24);
  }
  const auto turn = *rc::gen::inRange(1U, 1000U);
  Eigen::Vector3d move;
  for (double& coordinate : move) coordinate = *rc::gen::inRange(-100, 100) / 100.0;
  return test::transformed(part, 1, test::rotation(turn), move);
}

RC_GTEST_PROP(OneDefinition, ConnectivityAgreesWithTheLocalDecision, ()) {
  std::vector<Shape> parts;
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) parts.push_back(random_part());
  const double offset = *rc::gen::inRange(6, 60) / 1000.0;
  const Shape joined = test::joined(parts);
  RC_ASSERT(is_closed_and_oriented(joined));
  const Shape shape = in_unit_frame(joined, unit_frame(joined));
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const Disputes disputes = disputes_about(shape, samples, offset);
  RC_ASSERT(disputes.invented == 0);
  // The thin end of a wedge may be missed, as the documentation says: in two of 4,400 cases it was, at up to 5 samples.
  RC_ASSERT(disputes.missed <= samples.points.rows() / 50);
}

void expect_no_dispute(const Shape& given, double offset) {
  ASSERT_TRUE(is_closed_and_oriented(given));
  const Shape shape = in_unit_frame(given, unit_frame(given));
  const Disputes disputes = disputes_about(shape, sample_shape(shape, SampleSite::faces), offset);
  EXPECT_EQ(disputes.invented, 0) << offset;
  EXPECT_EQ(disputes.missed, 0) << offset;
}

/// Two boxes whose sides cross at 8 degrees: along the crossing E(r) ends in a wedge that is narrower than the finest
/// cubes for a third of r.
TEST(OneDefinition, HoldsInTheWedgeBetweenTwoWalls) {
  const auto part = [](double size, unsigned turn, const Eigen::Vector3d& move) {
    return test::transformed(test::box({size, 2 * size, 0.8}, 4), 1, test::rotation(turn), move);
  };
  expect_no_dispute(test::joined({part(0.34, 149, {-0.53, -0.5, -0.18}), part(0.3, 342, {-0.21, -0.09, -0.29})}),
                    0.018);
}

TEST(OneDefinition, HoldsOnScannedAndModelledShapes) {
  const char* const data = std::getenv("SHAPEGAUGE_DATA");
  if (data == nullptr) GTEST_SKIP() << "SHAPEGAUGE_DATA names no folder with real meshes";
  for (const char* const name : {"T0.off", "T200.off", "T380.off", "T540.off"}) {
    SCOPED_TRACE(name);
    const Shape shape = read_shape(std::filesystem::path(data) / "shrec11_nonrigid" / name);
    for (const double offset : {0.01, 0.03, 0.05}) expect_no_dispute(shape, offset);
  }
}

}  // namespace
}  // namespace shapegauge
