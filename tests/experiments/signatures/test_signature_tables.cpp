// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/signatures/signature_tables.h"

namespace shapegauge {

namespace {

using ::testing::ElementsAre;

SignatureConfiguration histogram_of(const char* name, const nlohmann::json& field, int bins = 80) {
  SignatureConfiguration signature;
  signature.name = name;
  signature.field = read_field(field);
  signature.histogram.options.bins = bins;
  return signature;
}

/// A model with a field of this range.
ModelDescription model_with_range(const Interval& range) {
  ModelDescription model;
  model.fields.emplace_back().range = range;
  return model;
}

ModelDescription model_without_field() {
  ModelDescription model;
  model.fields.emplace_back().error = "why";
  return model;
}

TEST(AssembleSignatures, ConcatenatesTermsInTheOrderOfTheConfiguration) {
  ModelDescription model;
  model.fields.resize(1);
  model.features = {{.features = Eigen::VectorXf{{0.25F, 0.75F}}}, {.features = Eigen::VectorXf{{1.0F}}}, {}};
  SignatureConfiguration both;
  both.parts = {1, 0};
  const std::vector<SignatureConfiguration> signatures{histogram_of("two", {{"type", "cone_sdf"}}, 2),
                                                       histogram_of("one", {{"type", "cone_sdf"}}, 1), both};
  const std::vector<Signatures> tables = assemble_signatures({&model}, distinct_fields(signatures), signatures, {});
  EXPECT_EQ(tables[2], (Signatures{{0.5F, 0.125F, 0.375F}}));
}

TEST(AssembleSignatures, GivesAModelWithoutASignatureARowOfNan) {
  const std::vector<SignatureConfiguration> signatures{histogram_of("two", {{"type", "cone_sdf"}}, 2)};
  ModelDescription with;
  with.fields.resize(1);
  with.features = {{.features = Eigen::VectorXf{{0.25F, 0.75F}}}};
  ModelDescription without = model_without_field();
  without.features.resize(1);
  const std::vector<Field> fields = distinct_fields(signatures);
  const Signatures table = assemble_signatures({&without, &with}, fields, signatures, {})[0];
  ASSERT_EQ(table.rows(), 2);
  EXPECT_TRUE(std::isnan(table(0, 0)) && std::isnan(table(0, 1)));
  EXPECT_EQ(table.row(1), (Signatures{{0.25F, 0.75F}}));
  EXPECT_EQ(assemble_signatures({&without}, fields, signatures, {})[0].cols(), 0);
}

TEST(FieldRanges, EncloseTheValuesOfModelsThatHaveTheField) {
  const ModelDescription low = model_with_range({.low = -1, .high = 2});
  const ModelDescription high = model_with_range({.low = 0, .high = 5});
  ModelDescription none = model_without_field();
  none.fields[0].range = {.low = -9, .high = 9};
  const std::vector<Interval> ranges = field_ranges({&low, &none, &high}, 1);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_EQ(ranges[0].low, -1);
  EXPECT_EQ(ranges[0].high, 5);
}

TEST(HistogramRanges, CoverOneShapeOrTheWholeDataSetOrAFixedInterval) {
  const ModelDescription low = model_with_range({.low = -1, .high = 2});
  const ModelDescription high = model_with_range({.low = 0, .high = 5});
  const auto highs = [&](HistogramRange range) {
    std::vector<double> all;
    HistogramConfiguration histogram;
    histogram.range = range;
    histogram.fixed = {.low = 0, .high = 7};
    for (const Interval& one : histogram_ranges({&low, &high}, histogram, 0)) all.push_back(one.high);
    return all;
  };
  EXPECT_THAT(highs(HistogramRange::per_shape), ElementsAre(2, 5));
  EXPECT_THAT(highs(HistogramRange::dataset), ElementsAre(5, 5));
  EXPECT_THAT(highs(HistogramRange::fixed), ElementsAre(7, 7));
}

}  // namespace

}  // namespace shapegauge
