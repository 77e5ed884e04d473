#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

namespace {

/// A model of diagonal 10 with gaps of this length, and what a field of a fixed offset and one that chose it made of
/// it.
ModelDescription model_with_gaps(double gap_size, double chosen_offset) {
  ModelDescription model;
  model.diagnostics.diagonal = 10;
  model.diagnostics.gap_size = gap_size;
  FieldDescription fixed;
  fixed.outcomes = {{"total", 8}, {"missing", 1}};
  fixed.seconds = 0.5;
  FieldDescription automatic = fixed;
  automatic.offset = chosen_offset;
  model.fields = {fixed, automatic};
  return model;
}

SignatureConfiguration histogram_of(const char* name, const nlohmann::json& field, int bins = 80) {
  SignatureConfiguration signature;
  signature.name = name;
  signature.field = read_field(field);
  signature.histogram.options.bins = bins;
  return signature;
}

TEST(AssembleSignatures, PartsStandInTheOrderOfTheirNames) {
  ModelDescription model;
  model.fields.resize(1);
  model.histograms = {Eigen::VectorXf{{0.25F, 0.75F}}, Eigen::VectorXf{{1.0F}}, {}};
  SignatureConfiguration both;
  both.parts = {1, 0};
  const std::vector<SignatureConfiguration> signatures{histogram_of("two", {{"type", "cone_sdf"}}, 2),
                                                       histogram_of("one", {{"type", "cone_sdf"}}, 1), both};
  const std::vector<Signatures> tables = assemble_signatures({&model}, plan_fields(signatures), signatures, {});
  EXPECT_EQ(tables[2], (Signatures{{0.5F, 0.125F, 0.375F}}));
}

TEST(ReportFields, CountsAndAddsOverTheModels) {
  const ModelDescription closed = model_with_gaps(0.4, 0.05);  // narrower than 0.05 of the diagonal
  const ModelDescription open = model_with_gaps(0.6, 0.05);
  const ModelDescription wide = model_with_gaps(0.6, 0.07);
  const std::vector<PlannedField> plan =
      plan_fields({histogram_of("fixed", {{"type", "offset_sdf"}, {"offset", 0.05}}),
                   histogram_of("auto", {{"type", "offset_sdf"}, {"offset", "auto"}})});
  ASSERT_EQ(plan.size(), 2U);
  const std::vector<FieldReport> reports = report_fields({&closed, &open, &wide}, plan);
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].models, 3U);
  EXPECT_EQ(reports[0].leaking, 2U);  // both with gaps wider than half a unit
  EXPECT_EQ(reports[1].leaking, 1U);  // the one whose chosen offset is below its gaps
  EXPECT_EQ(reports[0].outcomes, (FieldOutcomes{{"total", 24}, {"missing", 3}}));
  EXPECT_EQ(reports[0].seconds, 1.5);
}

}  // namespace

}  // namespace shapegauge
