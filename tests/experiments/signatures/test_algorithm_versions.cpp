// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/histogram.h"
#include "tests/support/test_shapes.h"

// Values in users' caches, with the versions of the algorithms that computed them. A failure means
// that a value has changed: increase the version, so that cached values are not used, and update the values here.
// Tolerances allow for other compilers and processors, whose last bits differ (of the offset SDF in single
// precision).

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// A convex, a bent and an open surface.
std::vector<Shape> shapes() {
  Shape open = test::box({1, 2, 0.3}, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 4, Eigen::NoChange);
  return {test::capsule(0.2, 2, 16, 6), test::torus(1, 0.3, 12, 8), open};
}

/// Statistics of a field on one shape; most changes of values change them.
struct Summary {
  double mean = 0;       ///< weighted by area
  double deviation = 0;  ///< from the mean, so weighted
  double area = 0;       ///< sum of the weights
};

/// Missing values count as 0.
Summary summary_of(const Eigen::VectorXd& computed, const Eigen::VectorXd& weights) {
  Summary summary{.area = weights.sum()};
  const Eigen::VectorXd values = computed.array().isNaN().select(0, computed);
  summary.mean = values.dot(weights) / summary.area;
  summary.deviation = std::sqrt((values.array() - summary.mean).square().matrix().dot(weights) / summary.area);
  return summary;
}

struct Recorded {
  Json settings;
  Json versions;
  std::vector<Summary> summaries;  ///< per shape
};

void PrintTo(const Recorded& recorded, std::ostream* stream) { *stream << recorded.settings; }

class RecordedFieldVersions : public testing::TestWithParam<Recorded> {};

TEST_P(RecordedFieldVersions, FieldValuesMatchThoseRecordedForTheirVersion) {
  const Field field = read_field(GetParam().settings);
  EXPECT_EQ(nlohmann::json(field.versions), GetParam().versions);
  const std::vector<Shape> all = shapes();
  ASSERT_EQ(GetParam().summaries.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PreparedShape prepared = prepare_shape(all[i], {});
    const Samples samples = take_samples(prepared.shape, field.settings.samples);
    FieldSource source(prepared.shape);
    const Summary found = summary_of(field.compute(source, samples, false).values, samples.weights);
    const Summary& recorded = GetParam().summaries[i];
    EXPECT_NEAR(found.mean, recorded.mean, 1e-6) << "shape " << i;
    EXPECT_NEAR(found.deviation, recorded.deviation, 1e-6) << "shape " << i;
    EXPECT_NEAR(found.area, recorded.area, 1e-9) << "shape " << i;
  }
}

/// Between crossing arms many samples are covered by other parts of the offset solid; on the shapes above hardly any.
TEST(OffsetSdfVersion, MatchesTheRecordedValuesOfTwoCrossingCapsules) {
  const Shape arm = test::capsule(0.2, 2, 16, 6);
  const Shape crossing = test::joined({arm, test::transformed(arm, 1, test::rotation(3), {0, 0, 0})});
  const PreparedShape prepared = prepare_shape(crossing, {});
  const Field field = read_field({{"type", "offset_sdf"}, {"offset", 0.05}});
  const Samples samples = take_samples(prepared.shape, field.settings.samples);
  FieldSource source(prepared.shape);
  const Summary found = summary_of(field.compute(source, samples, false).values, samples.weights);
  ASSERT_EQ(field.versions, (AlgorithmVersions{{"offset_sdf", 13}}));
  EXPECT_NEAR(found.mean, 0.204830418962, 1e-6);
  EXPECT_NEAR(found.deviation, 0.0807011254096, 1e-6);
}

/// At least one for each type of field.
const std::vector<Recorded> field_records{
    Recorded{{{"type", "offset_sdf"}, {"offset", 0.05}},
             {{"offset_sdf", 13}},
             {{0.242653915264, 0.0889625310615, 1},
              {0.167920601592, 0.00469943333799, 1},
              {0.146101084313, 0.251082068399, 1}}},
    Recorded{{{"type", "offset_sdf"}, {"offset", "auto"}},
             {{"offset_sdf", 13}, {"automatic_offset", 3}},
             {{0.238434649214, 0.0698555617861, 1}, {0.167916106353, 0.00469944274785, 1}, {0, 0, 1}}},
    Recorded{{{"type", "cone_sdf"}, {"at", "vertices"}},
             {{"cone_sdf", 3}},
             {{0.232795342978, 0.0184649490631, 1},
              {0.178653326058, 0.00590609399661, 1},
              {0.2384317788, 0.121570595955, 1}}},
    Recorded{{{"type", "cone_sdf"}, {"engine", "cgal"}},
             {{"cone_sdf", 3}},
             {{0.231977234255, 0.018015454063, 1},
              {0.16875778698, 0.00462984133005, 1},
              {0.216233404362, 0.131093401095, 1}}},
    Recorded{{{"type", "cone_sdf"}, {"at", {{"surface", 50}}}},
             {{"cone_sdf", 3}},
             {{0.229121719107, 0.00860165659469, 1},
              {0.171100542702, 0.00698436038499, 1},
              {0.179804427187, 0.100130395241, 1}}},
    Recorded{{{"type", "cone_sdf"}, {"bilateral", {{"spatial_width", 0.1}}}},
             {{"cone_sdf", 3}, {"bilateral", 2}},
             {{0.231911001733, 0.0177264830065, 1},
              {0.168726834873, 0.00453162312508, 1},
              {0.215488226882, 0.129339721505, 1}}},
    Recorded{{{"type", "inscribed_ball"}},
             {{"inscribed_ball", 4}},
             {{0.22272871256, 0.0787247009245, 1},
              {0.158263004725, 0.00621857897796, 1},
              {0.28339756369, 0.239867872997, 1}}},
    Recorded{{{"type", "gap"}}, {{"inscribed_ball", 4}}, {{0, 0, 1}, {0.0484164269326, 0.128635874813, 1}, {0, 0, 1}}},
    Recorded{{{"type", "centricity"}, {"sources", 10}},
             {{"centricity", 2}},
             {{0.733580482658, 0.00835312157243, 1},
              {0.50818944009, 0.0340711017093, 1},
              {0.508725727755, 0.0371406930241, 1}}},
    Recorded{
        {{"type", "heat_kernel"}, {"eigenvalues", 20}},
        {{"heat_kernel", 3}},
        {{2.77857635004, 0.0592608896745, 1}, {4.98598287561, 0.952004588327, 1}, {5.87461205629, 0.946088913311, 1}}},
    Recorded{
        {{"type", "scale_invariant_heat_kernel"}, {"eigenvalues", 20}},
        {{"heat_kernel", 3}},
        {{2.74588568815, 0.356760653803, 1}, {2.93777064724, 0.047911871497, 1}, {2.92259960366, 0.155531032212, 1}}},
    Recorded{{{"type", "wave_kernel"}, {"energy", 3}, {"eigenvalues", 20}},
             {{"heat_kernel", 3}},
             {{1, 0.000779669197191, 1}, {1, 0.369587130602, 1}, {1, 0.672852617938, 1}}},
    Recorded{{{"type", "centricity"}, {"on", "proxy"}},
             {{"centricity", 2}, {"surface_proxy", 5}},
             {{0.493723502611, 0.0949150207929, 1},
              {0.466656530342, 0.0326466806524, 1},
              {0.470003779904, 0.0476988769337, 1}}},
    Recorded{
        {{"type", "heat_kernel"}, {"on", "proxy"}, {"eigenvalues", 20}},
        {{"heat_kernel", 3}, {"surface_proxy", 5}},
        {{4.27886408988, 0.693281556472, 1}, {4.1256332695, 0.359699427998, 1}, {4.87597480109, 1.03229537213, 1}}}};

/// Expects a record for each name; types that other tests add need none.
template <typename Records>
void expect_records(const std::vector<std::string>& names, const Records& records) {
  for (const std::string& name : names) {
    if (name.starts_with("test_")) continue;
    EXPECT_TRUE(std::ranges::any_of(records, [&](const auto& record) { return record.settings["type"] == name; }))
        << "record values of " << name << " here";
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RecordedFieldVersions, testing::ValuesIn(field_records));

TEST(RecordedFieldValues, ExistForEachFieldType) { expect_records(field_types().names(), field_records); }

/// Statistics of a descriptor on the three shapes: per shape, the sum of features and the sum weighted by position,
/// counted from 1, over their number; and the distances between the first shape and the others.
struct RecordedDescriptor {
  Json settings;
  int version = 0;
  std::vector<double> numbers;
};

void PrintTo(const RecordedDescriptor& recorded, std::ostream* stream) { *stream << recorded.settings; }

class RecordedDescriptorVersions : public testing::TestWithParam<RecordedDescriptor> {};

std::vector<double> numbers_of(const DescriptorChoice& choice) {
  std::vector<PreparedShape> prepared;
  std::vector<std::vector<ScalarField>> fields;
  for (const Shape& shape : shapes()) {
    const Shape& ready = prepared.emplace_back(prepare_shape(shape, {})).shape;
    FieldSource source(ready);
    auto& of_shape = fields.emplace_back();
    for (const Field& field : choice.fields) {
      const Samples samples = take_samples(ready, field.settings.samples);
      of_shape.push_back({field.compute(source, samples, false).values, samples.weights});
    }
  }
  std::vector<DescriptorInput> inputs;
  for (std::size_t i = 0; i < prepared.size(); ++i) inputs.push_back({prepared[i].shape, fields[i]});
  const bool learning = needs_learning(choice.descriptor, choice.values);
  const LearntFeatures learnt = learning ? choice.descriptor.learn(inputs, choice.values) : LearntFeatures{};
  Signatures features;
  std::vector<double> numbers;
  for (const DescriptorInput& input : inputs) {
    const Eigen::VectorXd found = choice.descriptor.describe(input, learnt, choice.values).cast<double>();
    features.conservativeResize(features.rows() + 1, found.size());
    features.bottomRows<1>() = found.transpose().cast<float>();
    numbers.push_back(found.sum());
    numbers.push_back(found.dot(Eigen::VectorXd::LinSpaced(found.size(), 1, static_cast<double>(found.size()))) /
                      static_cast<double>(found.size()));
  }
  const DistanceMatrix distances = descriptor_distances(choice.descriptor, features);
  numbers.insert(numbers.end(), {distances(0, 1), distances(0, 2)});
  return numbers;
}

TEST_P(RecordedDescriptorVersions, FeaturesMatchThoseRecordedForTheDescriptorVersion) {
  const DescriptorChoice choice = make_descriptor(GetParam().settings);
  EXPECT_EQ(choice.descriptor.version, GetParam().version);
  const std::vector<double> found = numbers_of(choice);
  ASSERT_EQ(found.size(), GetParam().numbers.size());
  // Features are in single precision; those of the light field are integers, a few of which may round differently.
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], GetParam().numbers[i], 1e-4 * std::max(1.0, std::abs(found[i]))) << "number " << i;
  }
}

const Json two_fields{{{"type", "cone_sdf"}}, {{"type", "centricity"}, {"sources", 10}}};

/// At least one for each descriptor.
const std::vector<RecordedDescriptor> descriptor_records{
    RecordedDescriptor{{{"type", "joint_histogram"}, {"fields", two_fields}},
                       2,
                       {0.999999981, 0.246301972, 0.999999998, 0.166473898, 1, 0.219391857, 1.99971883, 1.99787547}},
    RecordedDescriptor{{{"type", "bag_of_features"}, {"words", 7}, {"fields", two_fields}},
                       1,
                       {1, 0.142857143, 1.00000003, 0.556180605, 1.00000002, 0.677089521, 2.00000003, 2.00000002}},
    RecordedDescriptor{{{"type", "light_field"}, {"pixels", 64}},
                       3,
                       {73762, 36850.8058, 70364, 34971.2902, 78737, 39160.6958, 17.5254902, 15.4666667}},
    RecordedDescriptor{
        {{"type", "spherical_harmonics"}},
        2,
        {49.2751949, 26.2526351, 43.7502794, 20.8272946, 73.8722302, 36.7951221, 4.12609432, 2.56034255}},
    RecordedDescriptor{{{"type", "d2"}, {"points", 100}},
                       2,
                       {1, 0.341142676, 1, 0.341161616, 0.999999999, 0.341070076, 0.524040404, 0.347878784}},
    RecordedDescriptor{{{"type", "shape_dna"}},
                       3005,
                       {49.002709, 28.2505905, 18.4892659, 9.94892606, 14.7858938, 7.83061545, 7.57527677, 8.28459551}},
    RecordedDescriptor{
        {{"type", "shape_dna"}, {"on", "proxy"}},
        3005,
        {20.0490271, 10.5833258, 21.2519672, 10.8234316, 17.9607571, 9.54263312, 1.28719979, 1.08769922}},
    RecordedDescriptor{
        {{"type", "geodesic_spectrum"}},
        1005,
        {-81.4436155, -49.0773442, -80.2422322, -48.4127842, -80.4336050, -48.6842827, 1.77136818, 0.952826244}},
    RecordedDescriptor{
        {{"type", "surflet_pairs"}},
        1005,
        {19.5658906, 7.60807875, 19.5462406, 6.45005868, 10.9660654, 3.82700136, 18.1791119, 19.9828287}},
    RecordedDescriptor{
        {{"type", "panorama"}},
        3,
        {683.257275, 476.282503, 594.60766, 412.353933, 1061.55727, 719.259699, 25.8085216, 27.9393965}}};

INSTANTIATE_TEST_SUITE_P(Each, RecordedDescriptorVersions, testing::ValuesIn(descriptor_records));

TEST(RecordedDescriptorValues, ExistForEachDescriptor) { expect_records(descriptors().names(), descriptor_records); }

TEST(HistogramVersion, MatchesTheRecordedHistograms) {
  const ScalarField field{.values = Eigen::VectorXd::LinSpaced(40, 0.1, 1.3).array().square(),
                          .weights = Eigen::VectorXd::LinSpaced(40, 1, 2)};
  EXPECT_EQ(histogram_version, 2);
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

struct RecordedMeasure {
  std::string name;
  int version = 0;
  double value = 0;
};

/// One for each measure: the mean over the queries of nine models.
const std::vector<RecordedMeasure> measure_records{{"NN", 1, 0.375},
                                                   {"FT", 1, 0.333333333333},
                                                   {"ST", 1, 0.75},
                                                   {"E", 1, 0.545454545455},
                                                   {"DCG", 1, 0.642023556961},
                                                   {"mAP", 1, 0.489930555556},
                                                   {"P@4", 1, 0.3125},
                                                   {"R@4", 1, 0.416666666667},
                                                   {"F1@4", 1, 0.357142857143},
                                                   {"MRR", 1, 0.645833333333},
                                                   {"nDCG", 1, 0.681127904667},
                                                   {"R-prec", 1, 0.333333333333},
                                                   {"bpref", 1, 0.263888888889},
                                                   {"AUC-PR", 1, 0.523536706349},
                                                   {"BEP", 1, 0.90625},
                                                   {"P@N", 1, 0.375},
                                                   {"R@N", 1, 1},
                                                   {"F1@N", 1, 0.545454545455},
                                                   {"mAP@N", 1, 0.489930555556},
                                                   {"nDCG@N", 1, 0.642023556961}};

TEST(MeasureVersions, ScoresMatchThoseRecordedForEachMeasureVersion) {
  const std::vector<double> positions{0, 1.1, 4.3, 2.05, 3.7, 7.2, 9.9, 5.6, 2.6};
  const std::vector<int> labels{0, 0, 0, 1, 1, 1, 1, 0, 2};
  const DistanceMatrix distances = DistanceMatrix::NullaryExpr(9, 9, [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(positions[static_cast<std::size_t>(i)] - positions[static_cast<std::size_t>(j)]);
  });
  for (const auto& [name, version, value] : measure_records) {
    const Measure measure = measure_of(name);
    EXPECT_EQ(measure.definition->version, version) << name;
    EXPECT_NEAR(evaluate(distances, labels, {.measures = {measure}}).micro[0], value, 1e-11) << name;
  }
  for (const std::string& name : measure_definitions().names()) {
    const std::string stem = name.ends_with("@k") ? name.substr(0, name.size() - 1) + "4" : name;
    EXPECT_TRUE(std::ranges::any_of(measure_records, [&](const auto& record) { return record.name == stem; }))
        << "record a value of " << name << " here";
  }
}

TEST(DistancesVersion, MatchesTheRecordedDistances) {
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
