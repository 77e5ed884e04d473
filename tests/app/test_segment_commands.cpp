// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/seg_file.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::StartsWith;

/// Two disjoint balls of different thickness: two parts in every segmentation.
Shape two_balls() {
  const Shape ball = test::sphere(1, 2);
  return test::joined({ball, test::transformed(ball, 0.5, Eigen::Matrix3d::Identity(), {5, 0, 0})});
}

/// One line per face: the first number for faces of one ball, the second for those of the other.
std::string segments(int first, int second) {
  std::string text;
  for (int i = 0; i < 640; ++i) text += fmt::format("{}\n", i < 320 ? first : second);
  return text;
}

class SegmentCommands : public CommandTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(at("psb/off"));
    for (const char* name : {"psb/off/1.off", "psb/off/21.off"}) write_off(at(name), two_balls());
    write_text(at("psb/seg/1/1_0.seg"), segments(0, 1));
    write_text(at("psb/seg/1/1_1.seg"), segments(3, 2));
    write_text(at("psb/seg/21/21_0.seg"), segments(0, 0));
  }
};

TEST_F(SegmentCommands, SegmentWritesOneLinePerFace) {
  for (const char* method : {"best", "paper"}) {
    const Outcome outcome =
        succeeded(run(fmt::format("segment @psb/off/1.off --method {} --replace -o @x.seg", method)));
    EXPECT_EQ(outcome.output, "");
    EXPECT_THAT(outcome.errors, HasSubstr("2 parts"));
    EXPECT_EQ(text_of(at("x.seg")), segments(0, 1));
  }
}

TEST_F(SegmentCommands, SegmentWritesASegFileByDefaultAndAcceptsFolders) {
  write_off(at("balls.off"), two_balls());
  const WorkingFolder here(folder_.path());
  const Outcome one = succeeded(run("segment balls.off"));
  EXPECT_THAT(one.errors, HasSubstr("2 parts in balls.seg\n"));
  EXPECT_EQ(text_of(at("balls.seg")), segments(0, 1));
  EXPECT_THAT(run("segment balls.off").errors, HasSubstr("--replace"));
  EXPECT_EQ(run("segment - < balls.off").output, segments(0, 1));
  EXPECT_EQ(run("segment psb/off -o parts/").status, 0);
  for (const char* name : {"parts/1.seg", "parts/21.seg"}) EXPECT_EQ(text_of(at(name)), segments(0, 1)) << name;
  expect_error_lines({{"segment psb", "the folder has no shapes"}});
}

TEST_F(SegmentCommands, WarnOfMorePartsThanRequested) {
  write_off(at("balls.off"), two_balls());
  EXPECT_THAT(succeeded(run("segment @balls.off -o @one.seg --parts 1")).errors, HasSubstr("2 parts instead of 1"));
  EXPECT_THAT(succeeded(run("segment @balls.off -o @two.seg --parts 2")).errors, testing::Not(HasSubstr("instead")));
}

TEST_F(SegmentCommands, SegmentRemovesOutliersIfTheOffsetIsAutomatic) {
  Shape cloud = test::random_points(test::box({2, 2, 0.4}, 1), 2000, 1);
  cloud.vertices.conservativeResize(2003, Eigen::NoChange);
  cloud.vertices.bottomRows<3>() << 30, 0, 0, 0, 30, 0, 0, 0, 30;
  write_off(at("cloud.off"), cloud);
  const auto lines_with = [&](const std::string& options) {
    const Outcome outcome = succeeded(run("segment @cloud.off --replace -o @x.seg " + options));
    EXPECT_THAT(outcome.errors, HasSubstr("3 of 2003 points are outliers"));
    const std::string text = text_of(at("x.seg"));
    return std::ranges::count(text, '\n');
  };
  EXPECT_EQ(lines_with("--method paper --offset auto"), 2000);
  EXPECT_EQ(lines_with("--method paper --offset 5%"), 2003);
  EXPECT_EQ(lines_with("--method paper --offset 5% --remove-outliers"), 2000);
}

TEST_F(SegmentCommands, SegmentWarnsOfACloudWithAHole) {
  const Shape whole = test::random_points(test::box({2, 2, 0.4}, 1), 6000, 1);
  std::vector<Eigen::Index> remaining;
  for (Eigen::Index i = 0; i < whole.vertices.rows(); ++i) {
    if (whole.vertices(i, 2) < 0.199 || whole.vertices.row(i).head<2>().norm() > 0.4) remaining.push_back(i);
  }
  for (const bool is_open : {false, true}) {
    write_off(at("x.off"), is_open ? Shape{whole.vertices(remaining, Eigen::all), {}} : whole);
    const Outcome outcome = run("segment @x.off --method paper --offset 5% --replace -o @x.seg");
    EXPECT_EQ(outcome.errors.find("outside on both sides") != std::string::npos, is_open) << outcome.errors;
  }
}

TEST_F(SegmentCommands, SegmentPassesItsOptionsToTheAlgorithm) {
  succeeded(run("segment @psb/off/1.off --patches 40 --min-probability 0.99 --border-width 0 -o @x.seg"));
  PartSegmentationOptions options{.patches = 40, .min_probability = 0.99};
  options.smoothing.width = 0;
  const Shape shape = read_shape(at("psb/off/1.off"));
  EXPECT_EQ(read_seg(at("x.seg"), shape), part_segmentation(shape, options));
}

TEST_F(SegmentCommands, SegmentWritesAnUprightPictureAndAPlyWithParts) {
  EXPECT_EQ(run("segment @psb/off/1.off -o @x.png").status, 0);
  const std::string upright = text_of(at("x.png"));
  EXPECT_THAT(upright, StartsWith("\x89PNG"));
  EXPECT_EQ(run("segment @psb/off/1.off --up x --replace -o @x.png").status, 0);
  EXPECT_NE(text_of(at("x.png")), upright);
  EXPECT_EQ(run("segment @psb/off/1.off -o @x.ply").status, 0);
  EXPECT_THAT(text_of(at("x.ply")), HasSubstr("property double part"));
  EXPECT_EQ(read_shape(at("x.ply")).triangles.rows(), 640);
}

TEST_F(SegmentCommands, SegmentWritesSeveralShapesIntoAFolder) {
  write_text(at("bad.off"), "OFF\n1 0 0\n");
  const Outcome outcome = run("segment @psb/off/1.off @bad.off @psb/off/21.off -o @out");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("bad.off"));
  EXPECT_EQ(text_of(at("out/1.seg")), segments(0, 1));
  EXPECT_EQ(text_of(at("out/21.seg")), segments(0, 1));
}

TEST_F(SegmentCommands, SegmentRejectsOptionsOutOfRangeOrOfAnotherMethod) {
  const std::string shape = quoted("psb/off/1.off");
  expect_error_lines(
      {{"segment " + shape + " -o x.obj", ".obj"},
       {"segment " + shape + " -o x.seg --parts 641", "641"},
       {"segment " + shape + " -o x.seg --parts -1", "--parts"},
       {"segment " + shape + " -o x.seg --parts 1000001", "--parts is 1000001; it must be a whole"},
       {"segment " + shape + " -o x.seg --patches 0", "--patches is 0; it must be a whole number from 1"},
       {"segment " + shape + " -o x.seg --field cone_sdf", "--method paper"},
       {"segment " + shape + " -o x.seg --method paper --field ball", "one of offset_sdf, cone_sdf"},
       {"segment " + shape + " -o x.seg --offset 0.1", "--method paper"},
       {"segment " + shape + " -o x.seg --method paper --border-width 0", "--method best"},
       {"segment " + quoted("absent.off") + " -o x.seg", "absent.off"}});
}

TEST_F(SegmentCommands, EvaluateSegmentationScoresMethodsAndHumanSegmentations) {
  write_text(at("good/1.seg"), segments(7, 8));
  write_text(at("good/21.seg"), segments(5, 5));
  for (const char* name : {"none/1.seg", "none/21.seg"}) write_text(at(name), segments(0, 0));
  const Outcome outcome = succeeded(run("evaluate-segmentation @good @none --benchmark @psb --format json"));
  const auto json = nlohmann::json::parse(outcome.output);
  ASSERT_EQ(json["methods"].size(), 3U);
  EXPECT_EQ(json["methods"][0]["name"], "good");
  EXPECT_EQ(json["methods"][0]["mean"]["Rand"], 0);
  // Of 640 faces in two halves, 320 * 320 of the pairs are separated: all wrong on one mesh, none on the other.
  const double separated = 320.0 * 320 / (640.0 * 639 / 2);
  EXPECT_NEAR(json["methods"][1]["mean"]["Rand"], separated / 2, 1e-12);
  EXPECT_NEAR(json["methods"][1]["per_class"]["human"]["Rand"], separated, 1e-12);
  EXPECT_EQ(json["methods"][1]["per_class"]["cup"]["Rand"], 0);
  EXPECT_EQ(json["methods"][2]["name"], "people");
}

TEST_F(SegmentCommands, EvaluateSegmentationWritesOneRowPerMesh) {
  write_text(at("good/1.seg"), segments(7, 8));
  write_text(at("good/21.seg"), segments(5, 5));
  succeeded(run("evaluate-segmentation @good --benchmark @psb --per-mesh @x.csv"));
  EXPECT_THAT(text_of(at("x.csv")), HasSubstr("good,21,cup,0,0,0,0,0,0,0\n"));
}

TEST_F(SegmentCommands, EvaluateSegmentationWarnsOfMeshesWithoutHumanSegmentations) {
  write_off(at("psb/off/2.off"), two_balls());
  const Outcome outcome = succeeded(run("evaluate-segmentation --benchmark @psb"));
  EXPECT_THAT(outcome.errors, HasSubstr("1 meshes without human segmentations (2"));
}

TEST_F(SegmentCommands, EvaluateSegmentationRejectsMissingOrTooShortSegmentations) {
  write_text(at("short/1.seg"), "1\n2\n");
  expect_error_lines({{"evaluate-segmentation --benchmark " + quoted("good"), "off"},
                      {"evaluate-segmentation " + quoted("short") + " --benchmark " + quoted("psb"), "2 lines"},
                      {"evaluate-segmentation " + quoted("absent") + " --benchmark " + quoted("psb"), "1.seg"}});
}

}  // namespace
}  // namespace shapegauge::test_command_line
