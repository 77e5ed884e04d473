#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/shape_comparison/measurement_records.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

const std::vector<PlannedField>& plan() {
  static const std::vector<PlannedField> fields{
      {.field = read_field({{"type", "cone_sdf"}}), .signatures = {0}, .keep_values = true},
      {.field = read_field({{"type", "heat_kernel"}}), .signatures = {1}}};
  return fields;
}

/// A reference with two fields, of which the first has kept values and the second normals.
MeasuredShape measured() {
  MeasuredShape shape;
  shape.read_seconds = 0.1;
  shape.description.area = 1.0 / 3;
  shape.description.diagnostics.gap_size = 0.7;
  shape.description.remarks = {"decimated to 4"};
  shape.description.fields.resize(2);
  shape.description.fields[0].values = Eigen::Vector3f(0.1F, std::numeric_limits<float>::quiet_NaN(), 7);
  shape.description.fields[0].weights = Eigen::Vector3f(0.2F, 0.3F, 0.5F);
  shape.description.fields[0].range = {.low = 0.1, .high = 7};
  shape.description.fields[1].offset = 0.03;
  shape.description.fields[1].outcomes = {{"total", 3}};
  shape.description.fields[1].seconds = 0.25;
  shape.description.histograms = {Eigen::VectorXf(), Eigen::Vector2f(0.1F, 0.9F)};
  shape.fields.resize(2);
  shape.fields[0].samples = 3;
  shape.fields[0].missing = 1;
  shape.fields[0].build_seconds = 0.3;
  shape.fields[0].query_seconds = 0.7;
  shape.fields[1].errors = {.median = 0.1,
                            .percentile_90 = std::numeric_limits<double>::quiet_NaN(),
                            .relative_median = 0.2,
                            .relative_percentile_90 = std::numeric_limits<double>::infinity()};
  shape.fields[1].offset_normals = {.mean = 1, .median = 2, .percentile_90 = 3};
  shape.fields[1].own_normals = {.mean = 4, .median = 5, .percentile_90 = 6};
  shape.reference = make_reference("key", test::box({1, 2, 3}, 2));
  shape.reference->values = {
      {.points = Points::Random(3, 3), .values = Eigen::Vector3d(1, 2, 1.0 / 3)},
      {.points = Points::Random(2, 3), .values = Eigen::Vector2d(4, 5), .dimension = FieldDimension::none}};
  return shape;
}

TEST(MeasurementRecords, RestoreEverything) {
  const MeasuredShape shape = measured();
  const MeasuredShape read = read_measured_bytes(measured_bytes(shape), plan());
  // Records have all numbers bit by bit.
  EXPECT_EQ(measured_bytes(read), measured_bytes(shape));
  EXPECT_EQ(read.read_seconds, 0.1);
  EXPECT_EQ(read.description.area, 1.0 / 3);
  EXPECT_EQ(read.description.diagnostics.gap_size, 0.7);
  EXPECT_THAT(read.description.remarks, testing::ElementsAre("decimated to 4"));
  EXPECT_EQ(read.description.fields[0].range.high, 7);
  EXPECT_EQ(read.description.fields[0].values[0], 0.1F);
  EXPECT_TRUE(std::isnan(read.description.fields[0].values[1]));
  EXPECT_EQ(read.description.fields[0].weights, shape.description.fields[0].weights);
  EXPECT_EQ(read.description.fields[1].offset, 0.03);
  EXPECT_EQ(read.description.fields[1].outcomes.at("total"), 3U);
  EXPECT_EQ(read.description.fields[1].seconds, 0.25);
  EXPECT_EQ(read.description.fields[1].values.size(), 0);
  EXPECT_EQ(read.description.histograms[0].size(), 0);
  EXPECT_EQ(read.description.histograms[1], shape.description.histograms[1]);
  EXPECT_EQ(read.fields[0].samples, 3U);
  EXPECT_EQ(read.fields[0].missing, 1U);
  EXPECT_EQ(read.fields[0].build_seconds, 0.3);
  EXPECT_EQ(read.fields[0].query_seconds, 0.7);
  EXPECT_FALSE(read.fields[0].errors || read.fields[0].offset_normals || read.fields[0].own_normals);
  EXPECT_TRUE(std::isnan(read.fields[1].errors->percentile_90));
  EXPECT_TRUE(std::isinf(read.fields[1].errors->relative_percentile_90));
  EXPECT_EQ(read.fields[1].errors->relative_median, 0.2);
  EXPECT_EQ(read.fields[1].offset_normals->percentile_90, 3);
  EXPECT_EQ(read.fields[1].own_normals->mean, 4);
}

TEST(MeasurementRecords, RestoreTheReference) {
  const MeasuredShape shape = measured();
  const ReferenceShape read = read_measured_bytes(measured_bytes(shape), plan()).reference.value();
  EXPECT_EQ(read.key, "key");
  EXPECT_EQ(read.shape.vertices, shape.reference->shape.vertices);
  EXPECT_EQ(read.shape.triangles, shape.reference->shape.triangles);
  EXPECT_EQ(read.diagonal, shape.reference->diagonal);
  EXPECT_DOUBLE_EQ(read.diagonal, std::sqrt(14));
  EXPECT_EQ(read.normals->at({0.5, 1, 3.1}), Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(read.values.size(), 2U);
  EXPECT_EQ(read.values[0].points, shape.reference->values[0].points);
  EXPECT_EQ(read.values[0].values, shape.reference->values[0].values);
  EXPECT_EQ(read.values[0].dimension, FieldDimension::length);
  EXPECT_EQ(read.values[1].dimension, FieldDimension::none) << "of the field in the plan";
}

TEST(MeasurementRecords, ACloudHasNoTrueNormals) {
  MeasuredShape shape = measured();
  shape.reference = make_reference("key", {.vertices = test::sphere(1, 1).vertices, .triangles = {}});
  shape.reference->values.resize(2);
  const ReferenceShape read = read_measured_bytes(measured_bytes(shape), plan()).reference.value();
  EXPECT_TRUE(is_cloud(read.shape));
  EXPECT_FALSE(read.normals);
  EXPECT_EQ(read.values[0].values.size(), 0);
}

TEST(MeasurementRecords, WithTooFewFieldsAreMalformed) {
  Json record = measured_record(measured());
  record["fields"].erase(1);
  EXPECT_THROW(read_measured_record(record, plan()), Json::exception);
  record = measured_record(measured());
  record["reference"]["values"].erase(1);
  EXPECT_THROW(read_measured_record(record, plan()), Json::exception);
}

}  // namespace

}  // namespace shapegauge
