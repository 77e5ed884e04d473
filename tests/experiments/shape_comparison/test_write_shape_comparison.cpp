// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "tests/experiments/shape_comparison/published_comparison.h"
#include "tests/support/csv_records.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

/// Results made by hand: a reference and another shape, a field with normals and errors, and one without.
class WriteShapeComparison : public test::FolderTest {
 protected:
  WriteShapeComparison() {
    for (const char* file : {"true.off", "other.off"}) write_off(at(file), test::box({1, 1, 1}, 1));
    results_.comparison = comparison_from_json(
        {{"name", "by hand"},
         {"shapes", {{{"name", "true"}, {"file", "true.off"}}, {{"name", "other"}, {"file", "other.off"}}}},
         {"reference", "true"},
         {"signatures",
          {{{"name", "first"}, {"field", {{"type", "cone_sdf"}}}, {"histogram", {{"range", "per-shape"}}}},
           {{"name", "second"},
            {"field", {{"type", "offset_sdf"}, {"offset", 0.05}}},
            {"histogram", {{"range", "per-shape"}}}}}}},
        "test.json", folder_.path());
    for (const char* name : {"true", "other"}) {
      MeasuredShape& shape = results_.shapes.emplace_back();
      shape.name = name;
      shape.read_seconds = 1.5;
      shape.fields.resize(2);
    }
    results_.shapes[1].fields[0] = {
        .samples = 40,
        .missing = 3,
        .build_seconds = 0.001,
        .query_seconds = 0.003,
        .errors =
            ValueErrors{.median = 0.01, .percentile_90 = 0.02, .relative_median = 0.3, .relative_percentile_90 = 0.4},
        .offset_normals = NormalErrors{.mean = 1, .median = 2, .percentile_90 = 3},
        .shape_normals = NormalErrors{.mean = 4, .median = 5, .percentile_90 = 6}};
    results_.shapes[0].fields[0].samples = 10;
    results_.shapes[0].fields[1].samples = 10;
    results_.shapes[1].fields[1].samples = 10;
    const Signatures first{{0.25, 0.75}, {1, 0}};
    const Signatures second{{0, 0, 0, 1}, {0.5, 0.5, 0, 0}};
    // The second signature is of the first field, so that indices of signatures and of fields differ.
    results_.signatures = {{.field = 1, .histograms = first, .ranges = {{1, 3}, {2, 6}}, .distances = {0, 1.5}},
                           {.field = 0, .histograms = second, .ranges = {{0, 1}, {0, 8}}, .distances = {0, 2.25}}};
  }
  [[nodiscard]] std::filesystem::path out(const std::string& name) const { return folder_.path() / "out" / name; }
  void write() const { test::publish(at("out"), results_); }
  [[nodiscard]] auto row(const char* file, const char* signature, const char* shape) const {
    return test::csv_record(out(file), {{"signature", signature}, {"shape", shape}});
  }
  ShapeComparisonResults results_;
};

TEST_F(WriteShapeComparison, WritesDistancesFromTheReference) {
  write();
  EXPECT_EQ(row("distances.csv", "first", "other").at("reference"), "true");
  EXPECT_THAT(test::csv_numbers(row("distances.csv", "first", "other"), {"l1"}), ElementsAre(1.5));
  EXPECT_THAT(test::csv_numbers(row("distances.csv", "second", "other"), {"l1"}), ElementsAre(2.25));
  EXPECT_THAT(test::csv_numbers(row("distances.csv", "second", "true"), {"l1"}), ElementsAre(0));
}

TEST_F(WriteShapeComparison, WritesFieldErrorsAndNormalErrorsOnlyWhereTheyExist) {
  write();
  EXPECT_THAT(test::csv_numbers(row("errors.csv", "second", "other"),
                                {"samples", "missing", "median_of_diagonal", "percentile_90_of_diagonal",
                                 "median_relative", "percentile_90_relative"}),
              ElementsAre(40, 3, 0.01, 0.02, 0.3, 0.4));
  EXPECT_THAT(
      test::csv_numbers(row("normals.csv", "second", "other"),
                        {"samples", "offset_mean_degrees", "offset_median_degrees", "offset_percentile_90_degrees",
                         "own_mean_degrees", "own_median_degrees", "own_percentile_90_degrees"}),
      ElementsAre(40, 1, 2, 3, 4, 5, 6));
  EXPECT_EQ(test::csv_records(out("errors.csv")).size(), 1U);
  EXPECT_EQ(test::csv_records(out("normals.csv")).size(), 1U);
}

TEST_F(WriteShapeComparison, WritesHistogramsWithTheBoundsOfBins) {
  write();
  const auto bin = [&](const char* signature, const char* shape, const char* number) {
    return test::csv_numbers(
        test::csv_record(out("histograms.csv"), {{"signature", signature}, {"shape", shape}, {"bin", number}}),
        {"low", "high", "share"});
  };
  EXPECT_THAT(bin("first", "true", "0"), ElementsAre(1, 2, 0.25));
  EXPECT_THAT(bin("first", "true", "1"), ElementsAre(2, 3, 0.75));
  EXPECT_THAT(bin("first", "other", "1"), ElementsAre(4, 6, 0));
  EXPECT_THAT(bin("second", "other", "1"), ElementsAre(2, 4, 0.5));
  EXPECT_THAT(bin("second", "true", "3"), ElementsAre(0.75, 1, 1));
}

TEST_F(WriteShapeComparison, WritesRunTimesPerShapeAndSample) {
  write();
  EXPECT_THAT(test::csv_numbers(row("timings.csv", "second", "other"),
                                {"read_seconds", "build_seconds", "query_seconds", "microseconds_per_sample"}),
              ElementsAre(1.5, 0.001, 0.003, 100));
}

TEST_F(WriteShapeComparison, WritesNoErrorsForUnregisteredShapes) {
  write();
  results_.comparison.registered = false;
  write();
  EXPECT_TRUE(std::filesystem::exists(out("distances.csv")));
  EXPECT_FALSE(std::filesystem::exists(out("errors.csv")));
  EXPECT_FALSE(std::filesystem::exists(out("normals.csv")));
}

TEST_F(WriteShapeComparison, ManifestListsInputsAndFailures) {
  results_.failures = {{.id = "gone", .message = "it is broken"}};
  write();
  const auto manifest = nlohmann::json::parse(test::text_of(out("manifest.json")));
  EXPECT_EQ(manifest.at("shapes"), 2);
  const auto& read = manifest.at("inputs").at("shapes");
  EXPECT_EQ(read.size(), 2U);
  EXPECT_EQ(read.at("true"), read.at("other")) << "the same bytes";
  ASSERT_EQ(manifest.at("failed_models").size(), 1U);
  EXPECT_EQ(manifest["failed_models"][0].at("model"), "gone");
  EXPECT_EQ(manifest["failed_models"][0].at("error"), "it is broken");
}

}  // namespace

}  // namespace shapegauge
