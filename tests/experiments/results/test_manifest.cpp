#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/results/manifest.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;
using test::write_text;

// SHA-256 of "abc" and of the empty text: FIPS 180-4.
constexpr const char* hash_of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Manifest, OutputsAreHashedButForTimings) {
  const test::TemporaryFolder folder;
  write_text(folder.path() / "summary.csv", "abc");
  write_text(folder.path() / "shape_seconds.csv", "1");
  const std::vector<std::string> files{"summary.csv", "shape_seconds.csv"};
  EXPECT_EQ(outputs_json(folder.path(), files),
            (OrderedJson{{"algorithm", "SHA-256"}, {"files", {{"summary.csv", hash_of_abc}}}}));
}

TEST(Manifest, FieldsHaveTheirOutcomesAndThoseWithAnOffsetItsLeaks) {
  const std::vector<FieldReport> fields{{.settings = {{"type", "offset_sdf"}, {"offset", 0.01}},
                                         .outcomes = {{"total", 7}, {"missing", 2}},
                                         .seconds = 3,
                                         .models = 5,
                                         .leaking = 4},
                                        {.settings = {{"type", "cone_sdf"}}, .outcomes = {{"total", 8}}, .seconds = 1}};
  const OrderedJson json = fields_json(fields);
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["samples"], (OrderedJson{{"missing", 2}, {"total", 7}}));
  EXPECT_EQ(json[0]["shapes_with_gaps_wider_than_offset"], 4);
  EXPECT_EQ(json[1], (OrderedJson{{"field", {{"type", "cone_sdf"}}}, {"samples", {{"total", 8}}}}));
}

TEST(Manifest, HoldsInputsFailuresAndWhatDiffersFromRunToRunApart) {
  const test::TemporaryFolder folder;
  write_text(folder.path() / "failed.off", "abc");
  ExperimentResults results;
  results.configuration.location =
      DatasetLocation{.layout = "shrec11", .root = folder.path(), .classification = folder.path() / "failed.off"};
  results.configuration.seed = 17;
  results.configuration.report.wanted = false;
  results.models = {{.id = "3", .file = "", .label = 1}, {.id = "5", .file = "", .label = 0}};
  results.shapes.resize(2);
  results.shapes[0].sha256 = "aa";
  results.shapes[1].sha256 = "bb";
  results.failures = {{.model = {.id = "7", .file = folder.path() / "failed.off", .label = 0}, .message = "broken"},
                      {.model = {.id = "8", .file = folder.path() / "absent.off", .label = 0}, .message = "absent"}};
  results.threads = 3;
  results.timings = {{"dataset", 0.5}, {"signatures", 2.0}};
  const OrderedJson json = manifest(results, {}, folder.path());
  EXPECT_EQ(json["inputs"]["models"], (OrderedJson{{"3", "aa"}, {"5", "bb"}, {"7", hash_of_abc}}));
  EXPECT_EQ(json["inputs"]["classification"], hash_of_abc);
  EXPECT_EQ(json["seed"], 17);
  EXPECT_EQ(json["models"], 2);
  EXPECT_EQ(json["failed_models"],
            (OrderedJson::array({{{"model", "7"}, {"error", "broken"}}, {{"model", "8"}, {"error", "absent"}}})));
  EXPECT_EQ(json["execution"]["threads"], 3);
  EXPECT_EQ(json["execution"]["seconds"], (OrderedJson{{"dataset", 0.5}, {"signatures", 2.0}}));
  EXPECT_EQ(json["execution"]["cache"], nullptr) << "there was none";
}

}  // namespace

}  // namespace shapegauge
