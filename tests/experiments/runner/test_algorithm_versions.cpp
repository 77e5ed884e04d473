#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/histogram.h"
#include "tests/support/test_shapes.h"

// Values that the caches of users hold, with the versions of the algorithms that made them. A test that fails here says
// that a value has changed: raise the version, so that caches give none of the old ones, and correct what is recorded.
// The tolerances leave room for other compilers and processors, whose last bits differ, and for nothing else.

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// A closed, a bent and an open surface.
std::vector<Shape> shapes() {
  Shape open = test::box({1, 2, 0.3}, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 4, Eigen::NoChange);
  return {test::capsule(0.2, 2, 16, 6), test::torus(1, 0.3, 12, 8), open};
}

/// What a field gives on one shape. Each number changes with most of the values; the deviation with where they are.
struct Summary {
  double mean = 0;       ///< weighted by area
  double deviation = 0;  ///< from the mean, so weighted
  double area = 0;       ///< sum of the weights
};

Summary summary_of(const Eigen::VectorXd& values, const Eigen::VectorXd& weights) {
  Summary summary{.area = weights.sum()};
  summary.mean = values.dot(weights) / summary.area;
  summary.deviation = std::sqrt((values.array() - summary.mean).square().matrix().dot(weights) / summary.area);
  return summary;
}

struct Recorded {
  Json settings;
  Json versions;
  std::vector<Summary> summaries;  ///< by shape
};

void PrintTo(const Recorded& recorded, std::ostream* stream) { *stream << recorded.settings; }

class FieldVersions : public testing::TestWithParam<Recorded> {};

TEST_P(FieldVersions, WithOtherValuesComesAnotherVersion) {
  const Field field = make_field(GetParam().settings);
  EXPECT_EQ(field.versions, GetParam().versions);
  const std::vector<Shape> all = shapes();
  ASSERT_EQ(GetParam().summaries.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PreparedShape prepared = prepare_shape(all[i], {});
    const Samples samples = take_samples(prepared.shape, field.samples);
    FieldSource source(prepared.shape);
    const Summary found = summary_of(field.compute(source, samples, false).values, samples.weights);
    const Summary& recorded = GetParam().summaries[i];
    EXPECT_NEAR(found.mean, recorded.mean, 1e-7) << "shape " << i;
    EXPECT_NEAR(found.deviation, recorded.deviation, 1e-7) << "shape " << i;
    EXPECT_NEAR(found.area, recorded.area, 1e-9) << "shape " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, FieldVersions,
                         testing::Values(Recorded{{{"type", "offset_sdf"}, {"offset", 0.05}},
                                                  {{"offset_sdf", 3}},
                                                  {{0.242654114482, 0.0889626912815, 1},
                                                   {0.167920601427, 0.00469944316594, 1},
                                                   {0.146103933907, 0.251080410628, 1}}},
                                         Recorded{{{"type", "offset_sdf"}, {"offset", "auto"}},
                                                  {{"offset_sdf", 3}, {"automatic_offset", 1}},
                                                  {{0.23843468731, 0.0698557003783, 1},
                                                   {0.167916104129, 0.00469944316594, 1},
                                                   {9.74892269818e-07, 3.19542528871e-18, 1}}},
                                         Recorded{{{"type", "cone_sdf"}, {"at", "vertices"}},
                                                  {{"cone_sdf", 2}},
                                                  {{0.232795342978, 0.0184649490631, 1},
                                                   {0.178653326058, 0.00590609399661, 1},
                                                   {0.2384317788, 0.121570595955, 1}}},
                                         Recorded{{{"type", "cone_sdf"}, {"engine", "cgal"}},
                                                  {{"cone_sdf", 2}},
                                                  {{0.231977234255, 0.018015454063, 1},
                                                   {0.16875778698, 0.00462984133005, 1},
                                                   {0.216233404362, 0.131093401095, 1}}},
                                         Recorded{{{"type", "cone_sdf"}, {"at", {{"surface", 50}}}},
                                                  {{"cone_sdf", 2}},
                                                  {{0.229121719107, 0.00860165659469, 1},
                                                   {0.171100542702, 0.00698436038499, 1},
                                                   {0.179804427187, 0.100130395241, 1}}}));

TEST(HistogramVersion, WithOtherHistogramsComesAnotherVersion) {
  const ScalarField field{.values = Eigen::VectorXd::LinSpaced(40, 0.1, 1.3).array().square(),
                          .weights = Eigen::VectorXd::LinSpaced(40, 1, 2)};
  EXPECT_EQ(histogram_version, 1);
  const Eigen::VectorXf plain = histogram(field, {.low = 0, .high = 1.7}, {.bins = 7});
  const Eigen::VectorXf smooth = histogram(field, {.low = 0, .high = 1.7}, {.bins = 7, .smoothing_bins = 1.5});
  const std::vector<float> recorded_plain{0.25F,        0.16452992F,   0.130341887F, 0.111965813F,
                                          0.118803419F, 0.0935897455F, 0.130769238F};
  const std::vector<float> recorded_smooth{0.197727457F, 0.176508859F, 0.148773894F, 0.127947897F,
                                           0.117567681F, 0.115202308F, 0.116271906F};
  EXPECT_THAT(std::vector<float>(plain.begin(), plain.end()),
              testing::Pointwise(testing::FloatNear(1e-6F), recorded_plain));
  EXPECT_THAT(std::vector<float>(smooth.begin(), smooth.end()),
              testing::Pointwise(testing::FloatNear(1e-6F), recorded_smooth));
}

TEST(DistancesVersion, WithOtherDistancesComesAnotherVersion) {
  Signatures signatures(3, 37);
  for (Eigen::Index i = 0; i < signatures.size(); ++i) signatures.data()[i] = 1.0F / static_cast<float>(i + 3);
  EXPECT_EQ(distances_version, 2);
  const DistanceMatrix distances = distance_matrix(signatures, "l1");
  // The sum of |1/(i + 3) - 1/(i + 40)| and so on, in double precision of the single-precision entries.
  double expected = 0;
  for (int i = 0; i < 37; ++i) {
    expected += std::abs(static_cast<double>(1.0F / static_cast<float>(i + 3)) -
                         static_cast<double>(1.0F / static_cast<float>(i + 40)));
  }
  EXPECT_NEAR(distances(0, 1), expected, 1e-12);
  EXPECT_EQ(distances(0, 1), distances(1, 0));
}

}  // namespace

}  // namespace shapegauge
