// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

Json comparison_document() {
  return Json::parse(R"({
    "name": "x",
    "shapes": [
      {"name": "clean", "file": "a.off"},
      {"name": "noisy", "file": "/b.off", "perturbations": [{"type": "vertex_noise", "amplitude": 0.01}]},
      {"name": "horse", "generate": {"class": "horse"}}
    ],
    "reference": "clean",
    "signatures": [{"name": "s", "field": {"type": "offset_sdf", "offset": 0.03}, "histogram": {"range": "per-shape"}}]
  })");
}

std::string comparison_error_with(const std::string& pointer, const Json& value) {
  Json changed = comparison_document();
  changed[Json::json_pointer(pointer)] = value;
  return test::input_error_of([&] { comparison_from_json(changed, "x.json", "/configs"); });
}

TEST(ReadComparison, FillsInDefaultsOfOmittedSettings) {
  const ShapeComparison comparison = comparison_from_json(comparison_document(), "x.json", "/configs");
  ASSERT_EQ(comparison.shapes.size(), 3U);
  EXPECT_EQ(comparison.shapes[0].file, "/configs/a.off");
  EXPECT_EQ(comparison.shapes[1].file, "/b.off");
  EXPECT_EQ(comparison.shapes[1].perturbations.size(), 1U);
  EXPECT_EQ(comparison.shapes[2].generated->faces, 4000);
  EXPECT_EQ(comparison.reference, 0U);
  EXPECT_TRUE(comparison.registered);
  EXPECT_EQ(comparison.seed, 1U);
  EXPECT_EQ(comparison.on_error, OnError::stop);
}

TEST(ReadComparison, IsReadBackFromJsonAsWritten) {
  Json full = comparison_document();
  full["registered"] = false;
  full["description"] = "why";
  full["preparation"]["scale"] = "tube_area";
  full["on_error"] = "skip";
  const Json filled = to_json(comparison_from_json(full, "x.json", "/configs"));
  EXPECT_EQ(to_json(comparison_from_json(filled, "again.json", "/elsewhere")), filled);
  EXPECT_EQ(filled["preparation"]["scale"], "tube_area");
  EXPECT_EQ(filled["registered"], false);
}

TEST(ReadComparison, ErrorsNameTheKeyAndSuggestTheClosestWord) {
  const std::vector<std::tuple<const char*, Json, const char*>> mistakes = {
      {"/reference", "claen", "reference: there is no shape \"claen\"; did you mean \"clean\"?"},
      {"/shapes/1/name", "clean", "shapes.1.name: the name \"clean\""},
      {"/shapes/2/generate/class", "hose", "shapes.2.generate.class: unknown word \"hose\""},
      {"/shapes/2/file", "c.off", "shapes.2.file: cannot be combined with \"generate\""},
      {"/shapes/0/fiel", "c.off", "shapes.0: unknown key \"fiel\""},
      {"/shapes/0", {{"name", "none"}}, "shapes.0: the key \"file\" is missing"},
      {"/regstered", true, "unknown key \"regstered\""},
      {"/signatures/0/concatenate", {"s"}, "signatures.0: unknown key \"concatenate\""},
      {"/shapes/0/file", "${SHAPEGAUGE_NOT_SET}/a.off", "shapes.0.file: the environment variable SHAPEGAUGE_NOT_SET"}};
  for (const auto& [pointer, value, word] : mistakes) {
    EXPECT_THAT(comparison_error_with(pointer, value), HasSubstr(word)) << pointer;
  }
  Json without = comparison_document();
  without.erase("reference");
  without["registered"] = true;
  EXPECT_THAT(test::input_error_of([&] { comparison_from_json(without, "x.json", ""); }),
              HasSubstr("registered: requires \"reference\""));
}

}  // namespace

}  // namespace shapegauge
