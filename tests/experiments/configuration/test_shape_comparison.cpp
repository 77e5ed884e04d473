#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
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

TEST(ReadComparison, FillsInDefaults) {
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

TEST(ReadComparison, AsJsonItReadsBackAsTheSame) {
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

TEST(ReadComparison, MistakesGiveThePlaceAndTheNearestWord) {
  EXPECT_THAT(comparison_error_with("/reference", "claen"),
              HasSubstr("reference: there is no shape \"claen\"; did you mean \"clean\"?"));
  EXPECT_THAT(comparison_error_with("/shapes/1/name", "clean"),
              HasSubstr("shapes.1.name: the name \"clean\" is already that of shapes.0"));
  EXPECT_THAT(comparison_error_with("/shapes/2/generate/class", "hose"),
              HasSubstr("shapes.2.generate.class: unknown word \"hose\"; did you mean \"horse\"?"));
  EXPECT_THAT(comparison_error_with("/shapes/2/file", "c.off"),
              HasSubstr("shapes.2.file: cannot be combined with \"generate\""));
  EXPECT_THAT(comparison_error_with("/shapes/0/fiel", "c.off"),
              HasSubstr("shapes.0: unknown key \"fiel\"; did you mean \"file\"?"));
  EXPECT_THAT(comparison_error_with("/shapes/0", {{"name", "none"}}),
              HasSubstr("shapes.0: the key \"file\" is missing"));
  EXPECT_THAT(comparison_error_with("/regstered", true),
              HasSubstr("unknown key \"regstered\"; did you mean \"registered\"?"));
  EXPECT_THAT(comparison_error_with("/dataset", Json::object()), HasSubstr("unknown key \"dataset\""));
  EXPECT_THAT(comparison_error_with("/signatures/0/concatenate", {"s"}),
              HasSubstr("signatures.0: unknown key \"concatenate\""));
  EXPECT_THAT(comparison_error_with("/shapes/0/file", "${SHAPEGAUGE_NOT_SET}/a.off"),
              HasSubstr("shapes.0.file: the environment variable SHAPEGAUGE_NOT_SET is not set"));
  Json without = comparison_document();
  without.erase("reference");
  without["registered"] = true;
  EXPECT_THAT(test::input_error_of([&] { comparison_from_json(without, "x.json", ""); }),
              HasSubstr("registered: needs a \"reference\""));
}

TEST(ReadComparison, TheKindsOfExperimentsAreNotMistakenForEachOther) {
  EXPECT_THAT(test::input_error_of([] { configuration_from_json(comparison_document(), "x.json", ""); }),
              HasSubstr("x.json: unknown key \"reference\" in a retrieval experiment; known here: "));
  Json retrieval = comparison_document();
  retrieval.erase("shapes");
  retrieval.erase("reference");
  retrieval["dataset"] = {{"layout", "shrec11"}, {"root", "data"}};
  EXPECT_THAT(test::input_error_of([&] { comparison_from_json(retrieval, "x.json", ""); }),
              HasSubstr("x.json: unknown key \"dataset\" in a comparison of shapes; known here: "));
}

TEST(ReadComparison, TheConfigurationsOfTheFiguresAreValid) {
  setenv("SHAPEGAUGE_DATA", "/data", 0);
  setenv("SHREC11_ROOT", "/data/shrec11", 0);
  int comparisons = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SHAPEGAUGE_CONFIGS_FOLDER "/paper")) {
    const Json read = read_json(entry.path());
    if (!read.contains("shapes")) continue;
    ++comparisons;
    EXPECT_EQ(test::input_error_of([&] { comparison_from_json(read, entry.path().string(), "/"); }), "no error");
  }
  EXPECT_EQ(comparisons, 7);
}

}  // namespace

}  // namespace shapegauge
