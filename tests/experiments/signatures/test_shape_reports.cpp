// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/signatures/shape_reports.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(DiagnosticsJson, NamesEveryDiagnostic) {
  Shape box = test::box({1, 1, 1}, 1);
  box.triangles = box.triangles.topRows(11).eval();
  const nlohmann::ordered_json json = diagnostics_json(diagnose(box));
  EXPECT_EQ(json["closed"], false);
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["triangles"], 11);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["boundary_edges"], 3);
  EXPECT_EQ(json["edges"], 18);
  EXPECT_DOUBLE_EQ(json["boundary_length"], 2 + std::sqrt(2));
  EXPECT_DOUBLE_EQ(json["boundary_fraction"], (2 + std::sqrt(2)) / std::sqrt(3));
}

TEST(DiagnosticsJson, ContainsNoNanForAnEmptyShape) {
  EXPECT_EQ(diagnostics_json(diagnose(Shape{}))["boundary_fraction"], 0);
}

TEST(PerturbationNote, CountsAffectedShapesAndNamesTheFirst) {
  std::vector<std::vector<std::string>> remarks(3);
  const std::vector<std::string> names{"a", "b", "c"};
  EXPECT_EQ(note_on_shapes(names, remarks, "model", not_perturbed), "");
  remarks[1] = {"one", "two"};
  remarks[2] = {"three"};
  EXPECT_EQ(note_on_shapes(names, remarks, "model", not_perturbed),
            "2 of 3 models were not perturbed as requested; the first, b: one; two");
}

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

TEST(FieldSummary, SumsSampleCountsAndRunTimesOverAllModels) {
  const ModelDescription closed = model_with_gaps(0.4, 0.05);  // narrower than 0.05 of the diagonal
  const ModelDescription open = model_with_gaps(0.6, 0.05);
  const ModelDescription wide = model_with_gaps(0.6, 0.07);
  const std::vector<Field> fields{read_field({{"type", "offset_sdf"}, {"offset", 0.05}}),
                                  read_field({{"type", "offset_sdf"}, {"offset", "auto"}})};
  const std::vector<FieldReport> reports = report_fields({&closed, &open, &wide}, fields);
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].models, 3U);
  EXPECT_EQ(reports[0].leaking, 2U);  // both with gaps wider than half a unit
  EXPECT_EQ(reports[1].leaking, 1U);  // the one whose chosen offset is below its gaps
  EXPECT_EQ(reports[0].outcomes, (FieldOutcomes{{"total", 24}, {"missing", 3}}));
  EXPECT_EQ(reports[0].seconds, 1.5);
}

struct Results {
  std::vector<std::string> classes;
  std::vector<Model> models;
  std::vector<FieldReport> fields;
  std::vector<ModelDescription> shapes;
  std::vector<SignatureConfiguration> signatures;
};

Results two_models() {
  Results results;
  results.classes = {"ant", "bird"};
  results.models = {{.id = "3", .file = "", .label = 1}, {.id = "5", .file = "", .label = 0}};
  results.fields = {{.settings = read_field({{"type", "offset_sdf"}, {"offset", 0.05}}).settings,
                     .outcomes = {{"total", 9}, {"undecided", 1}}}};
  results.shapes.resize(2);
  for (ModelDescription& shape : results.shapes) shape.fields.resize(1);
  results.shapes[0].diagnostics = {.triangles = 4, .closed = true};
  results.shapes[0].chosen = {2, 0};
  results.shapes[0].fields[0].outcomes = {{"total", 4}};
  results.shapes[0].fields[0].seconds = 0.25;
  results.shapes[1].diagnostics = {.triangles = 5};
  results.shapes[1].fields[0].outcomes = {{"total", 5}, {"undecided", 1}};
  results.shapes[1].fields[0].seconds = 1.5;
  return results;
}

std::string cell(const TextTable& table, std::size_t row, const std::string& column) {
  const auto found = std::ranges::find(table.header, column);
  return found == table.header.end() ? "no such column"
                                     : table.rows.at(row).at(static_cast<std::size_t>(found - table.header.begin()));
}

TEST(ShapesTable, ContainsDiagnosticsAndSampleOutcomesOfEachModel) {
  const Results results = two_models();
  const TextTable table = shapes_table(results.models, results.classes, results.shapes, {}, results.fields);
  ASSERT_EQ(table.rows.size(), 2U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  EXPECT_EQ(cell(table, 0, "id"), "3");
  EXPECT_EQ(cell(table, 0, "class"), "bird");
  EXPECT_EQ(cell(table, 0, "choices"), "2 0");
  EXPECT_EQ(cell(table, 0, "closed"), "true");
  EXPECT_EQ(cell(table, 0, "triangles"), "4");
  EXPECT_EQ(cell(table, 0, "offset_sdf accuracy=standard at=faces offset=0.05: total"), "4");
  EXPECT_EQ(cell(table, 0, "offset_sdf accuracy=standard at=faces offset=0.05: undecided"), "0");
  EXPECT_EQ(cell(table, 1, "choices"), "");
  EXPECT_EQ(cell(table, 1, "offset_sdf accuracy=standard at=faces offset=0.05: undecided"), "1");
}

TEST(ShapeSecondsTable, ContainsTheRunTimeOfEachField) {
  const Results results = two_models();
  const TextTable table = shape_seconds_table(results.models, results.shapes, results.fields, results.signatures);
  EXPECT_EQ(table.header, (std::vector<std::string>{"id", "offset_sdf accuracy=standard at=faces offset=0.05"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"3", "0.250000"}, {"5", "1.500000"}}));
}

TEST(ShapeSecondsTable, ContainsTheRunTimeOfEachDescriptor) {
  Results results = two_models();
  SignatureConfiguration& signature = results.signatures.emplace_back();
  signature.name = "SH";
  signature.descriptor = make_descriptor({{"type", "spherical_harmonics"}});
  results.shapes[0].features = {{.features = {}, .seconds = 0.5}};
  results.shapes[1].features = {{.features = {}, .seconds = 2}};
  const TextTable table = shape_seconds_table(results.models, results.shapes, results.fields, results.signatures);
  EXPECT_EQ(table.header.back(), "SH");
  EXPECT_EQ(table.rows[0].back(), "0.500000");
  EXPECT_EQ(table.rows[1].back(), "2.000000");
}

TEST(FieldsJson, CountsSampleOutcomesAndModelsWithUnclosedGaps) {
  const std::vector<FieldReport> fields{
      {.settings = read_field({{"type", "offset_sdf"}, {"offset", 0.01}}).settings,
       .outcomes = {{"total", 7}, {"missing", 2}},
       .seconds = 3,
       .models = 5,
       .leaking = 4},
      {.settings = read_field({{"type", "cone_sdf"}}).settings, .outcomes = {{"total", 8}}, .seconds = 1}};
  const nlohmann::ordered_json json = fields_json(fields);
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["samples"], (nlohmann::ordered_json{{"missing", 2}, {"total", 7}}));
  EXPECT_EQ(json[0]["shapes_with_gaps_wider_than_offset"], 4);
  EXPECT_EQ(json[1], (nlohmann::ordered_json{{"field", to_json(fields[1].settings)}, {"samples", {{"total", 8}}}}));
}

TEST(ExecutionJson, ContainsThreadsTimesAndCacheUse) {
  const std::vector<std::pair<std::string, double>> timings{{"dataset", 0.5}, {"signatures", 2.0}};
  const nlohmann::ordered_json execution = execution_json(3, timings, two_models().fields, {});
  EXPECT_EQ(execution["threads"], 3);
  EXPECT_EQ(execution["seconds"], (nlohmann::ordered_json{{"dataset", 0.5}, {"signatures", 2.0}}));
  EXPECT_EQ(execution["field_seconds"][0]["field"]["type"], "offset_sdf");
  EXPECT_EQ(execution["cache"], nullptr) << "there was none";
}

}  // namespace

}  // namespace shapegauge
