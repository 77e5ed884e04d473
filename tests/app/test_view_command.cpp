// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/app/program.h"
#include "tests/support/page_text.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using nlohmann::ordered_json;
using test::text_of;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;

class ViewCommand : public CommandTest {
 protected:
  void SetUp() override { write_off(at("capsule.off"), capsule); }
  [[nodiscard]] Outcome view(const std::string& arguments) const {
    return run("view " + arguments + " --replace -o @page.html");
  }
  /// Data shown on the page.
  [[nodiscard]] ordered_json page() const { return test::json_of_page(text_of(at("page.html"))); }
  [[nodiscard]] std::vector<std::string> field_names() const {
    std::vector<std::string> names;
    const ordered_json shown = page();
    for (const ordered_json& field : shown["shapes"][0]["fields"]) names.push_back(field["name"]);
    return names;
  }

  Shape capsule = test::capsule(1, 4, 16, 6);
};

TEST_F(ViewCommand, ColoursUseTheRequestedRangeThresholdAndUnit) {
  succeeded(view("@capsule.off --field cone_sdf --no-parts --unit cm --range 0.5,3 --scale log --below 15mm"));
  const ordered_json shown = page();
  EXPECT_EQ(shown["unit"], "cm");
  const ordered_json& field = shown["shapes"][0]["fields"][0];
  EXPECT_EQ(field["from"], 0.5);
  EXPECT_EQ(field["to"], 3);
  EXPECT_EQ(field["log"], true);
  EXPECT_EQ(field["below"], 1.5);
}

TEST_F(ViewCommand, InitialViewHasTheUpAxisVertical) {
  const auto up_shown = [&](const std::string& name, const std::string& more) {
    EXPECT_EQ(view(quoted(name) + " --field cone_sdf --no-parts " + more).status, 0);
    const ordered_json axes = page()["shapes"][0]["axes"];
    const auto row = axes[1].get<std::vector<double>>();
    Eigen::Index largest = 0;
    Eigen::Map<const Eigen::Vector3d>(row.data()).cwiseAbs().maxCoeff(&largest);
    return (row[static_cast<std::size_t>(largest)] < 0 ? "-" : "") + std::string(1, "xyz"[largest]);
  };
  for (const auto& [name, axis] : {std::pair("capsule.off", "y"), {"up.OBJ", "y"}, {"up.ply", "z"}, {"up.stl", "z"}}) {
    shape_writer(name)(at(name), capsule, {});
    EXPECT_EQ(up_shown(name, ""), axis) << name;
  }
  write_off(at("stated.off"), capsule, "# up: -z");
  EXPECT_EQ(up_shown("stated.off", ""), "-z");
  for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
    EXPECT_EQ(up_shown("capsule.off", std::string("--up ") + axis), axis);
  }
}

TEST_F(ViewCommand, PageContainsTheWarningAboutAHollowShape) {
  write_off(at("hollow.off"), test::joined({test::sphere(2, 2), test::flipped(test::sphere(1, 2))}));
  succeeded(view("@hollow.off --field offset_sdf --no-parts"));
  ASSERT_EQ(page()["warnings"].size(), 1U);
  EXPECT_THAT(page()["warnings"][0].get<std::string>(), testing::AllOf(HasSubstr("hollow.off"), HasSubstr("hull")));
}

TEST_F(ViewCommand, ShowsPartsNormalsAndTwoKindsOfSdfByDefault) {
  const Outcome outcome = succeeded(view("@capsule.off --offset 0.02"));
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(field_names(), ElementsAre("SDF of the offset surface", "Conventional SDF"));
  const ordered_json shape = page()["shapes"][0];
  EXPECT_EQ(shape["name"], "capsule.off");
  EXPECT_EQ(page()["title"], "capsule.off");
  EXPECT_EQ(shape["triangles"]["count"], capsule.triangles.rows());
  EXPECT_TRUE(shape.contains("parts") && shape.contains("directions"));
  const Samples samples = sample_shape(capsule, SampleSite::faces);
  const Eigen::VectorXd expected = offset_sdf(capsule, samples, {.offset = 0.02}).values;
  EXPECT_EQ(shape["fields"][0]["low"], expected.minCoeff());
  EXPECT_EQ(shape["fields"][0]["high"], expected.maxCoeff());
}

TEST_F(ViewCommand, ShowsTheRequestedScalarFields) {
  const std::string calls =
      R"( --no-parts --field centricity --field offset_sdf,offset=0.03 --field '{"type": "heat_kernel", "time": 0.1}')";
  ASSERT_EQ(view("@capsule.off" + calls).status, 0);
  EXPECT_THAT(field_names(),
              ElementsAre("centricity", "SDF of the offset surface, offset 0.03", "heat_kernel, time 0.1"));
  EXPECT_FALSE(page()["shapes"][0].contains("parts"));
}

TEST_F(ViewCommand, MeasuresLargeMeshesInFullAndShowsThemSimplified) {
  const Shape fine = test::sphere(1, 4);
  write_off(at("fine.off"), fine);
  ASSERT_EQ(view("@fine.off --max-faces 500 --no-parts --field cone_sdf").status, 0);
  const ordered_json shape = page()["shapes"][0];
  EXPECT_LE(shape["triangles"]["count"], 500);
  EXPECT_GE(shape["triangles"]["count"], 250);
  EXPECT_THAT(shape["note"].get<std::string>(), HasSubstr("5120 faces of which "));
  // Means of the sphere's values; those of the simplified mesh differ.
  const Eigen::VectorXd values = cone_sdf(fine, sample_shape(fine, SampleSite::faces), {}).values;
  EXPECT_GE(shape["fields"][0]["low"], values.minCoeff());
  EXPECT_LE(shape["fields"][0]["high"], values.maxCoeff());
  const Shape coarse = test::sphere(1, 2);
  EXPECT_LT(cone_sdf(coarse, sample_shape(coarse, SampleSite::faces), {}).values.minCoeff(), values.minCoeff());
}

TEST_F(ViewCommand, NamesUnusableShapesAndShowsOtherShapes) {
  write_text(at("broken.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  write_text(at("cloud.xyz"), "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n");
  const Outcome outcome = view("@broken.off @capsule.off @cloud.xyz --title Three --offset 0.4");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("broken.off"));
  EXPECT_EQ(page()["title"], "Three");
  EXPECT_EQ(page()["missing"], ordered_json({"broken.off"}));
  ASSERT_EQ(page()["shapes"].size(), 2U);
  EXPECT_EQ(page()["shapes"][1]["fields"].size(), 1U) << "a cloud has no conventional SDF";
}

TEST_F(ViewCommand, StandardOutputEqualsThePageFile) {
  const std::string call = "@capsule.off @capsule.off --offset 0.05";
  ASSERT_EQ(view(call).status, 0);
  EXPECT_TRUE(run("view " + call + " -o -").output == text_of(at("page.html")));
}

TEST_F(ViewCommand, NamesThePageAfterTheShapeByDefault) {
  const WorkingFolder here(at(""));
  ASSERT_EQ(view("capsule.off").status, 0);
  const Outcome outcome = succeeded(run("view capsule.off"));
  EXPECT_THAT(outcome.errors, HasSubstr("page: capsule.html\n"));
  EXPECT_EQ(text_of(at("capsule.html")), text_of(at("page.html")));
}

TEST_F(ViewCommand, RejectsMissingFilesUnknownFieldsAndContradictoryOptions) {
  write_text(at("cloud.xyz"), "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::string good = "view " + quoted("capsule.off") + " ";
  const std::string out = " -o " + quoted("x.html") + " ";
  const std::vector<UnusableCall> cases{
      {"view /nowhere.off" + out, "/nowhere.off"},
      {good + quoted("cloud.xyz"), "--output is required"},
      {good + "-o x.png", "must end in .html"},
      {good + "--field cone" + out, "--field cone"},
      {good + "--field offset_sdf,ofset=0.1" + out, "offset"},
      {good + "--field offset_sdf,offset=0" + out, "offset"},
      {good + "--field cone_sdf --field cone_sdf" + out, "is repeated"},
      {good + "--field cone_sdf,at=vertices" + out, "at the faces of a mesh"},
      {good + "--field cone_sdf --offset 0.1" + out, "--offset requires"},
      {good + "--parts 3 --no-parts" + out, "--no-parts"},
      {good + "--max-faces 3" + out, "--max-faces"},
      {"view " + quoted("cloud.xyz") + " --field cone_sdf" + out, "cloud.xyz: the conventional SDF needs triangles"}};
  expect_error_lines(cases);
}

}  // namespace

}  // namespace shapegauge::test_command_line
