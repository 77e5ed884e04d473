// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::StartsWith;

/// A sphere, a box, and a file without a shape.
class ShapeFileCommands : public CommandTest {
 protected:
  void SetUp() override {
    write_off(at("sphere.off"), test::sphere(10, 2));
    write_off(at("box.off"), test::box({1, 2, 3}, 1));
    write_text(at("broken.off"), "OFF\n3 1 0\n0 0 0\n");
  }
};

TEST_F(ShapeFileCommands, WriteTheSameResultForAFileAloneOrAmongSeveral) {
  for (const std::string command : {"sdf --method cone_sdf", "normals", "convert", "perturb --noise 0.01"}) {
    ASSERT_EQ(run(command + " @sphere.off @box.off -o @many/").status, 0) << command;
    for (const std::string name : {"sphere", "box"}) {
      const std::string file = command.starts_with("sdf") || command == "normals" ? name + ".csv" : name + ".off";
      ASSERT_EQ(run(fmt::format("{} @{}.off --replace -o @alone-{}", command, name, file)).status, 0);
      EXPECT_EQ(text_of(at("many/" + file)), text_of(at("alone-" + file))) << command;
    }
    fs::remove_all(at("many"));
  }
}

TEST_F(ShapeFileCommands, CreateAFolderForSeveralOutputs) {
  ASSERT_EQ(run("convert @sphere.off @box.off -o @pair --output-format ply").status, 0);
  EXPECT_EQ(read_shape(at("pair/sphere.ply")).vertices.rows(), test::sphere(10, 2).vertices.rows());
  EXPECT_EQ(read_shape(at("pair/box.ply")).vertices.rows(), test::box({1, 2, 3}, 1).vertices.rows());
}

TEST_F(ShapeFileCommands, ProcessOtherFilesAfterAnUnreadableFile) {
  const Outcome outcome = run("convert @sphere.off @broken.off @absent.off @box.off -o @out --output-format ply");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("broken.off"));
  EXPECT_THAT(outcome.errors, HasSubstr("absent.off"));
  EXPECT_THAT(outcome.errors, HasSubstr("2 of 4 shapes"));
  EXPECT_EQ(read_shape(at("out/box.ply")).vertices, read_shape(at("box.off")).vertices);
  EXPECT_TRUE(fs::exists(at("out/sphere.ply")));
  EXPECT_FALSE(fs::exists(at("out/broken.ply")));
}

TEST_F(ShapeFileCommands, PrefixWarningsWithTheFileNameOfTheShape) {
  write_text(at("sheet.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Outcome outcome = succeeded(run("sdf @sphere.off @sheet.off --method cone_sdf -o @out/"));
  EXPECT_THAT(outcome.errors, testing::StartsWith(fmt::format("shapegauge: warning: {}: 1 of 1 samples missing",
                                                              at("sheet.off").string())));
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << "the sphere has no remarks";
}

TEST_F(ShapeFileCommands, DoNotOverwriteInputsOrWriteTwoOutputsToOneFile) {
  fs::create_directory(at("other"));
  fs::copy_file(at("box.off"), at("other/box.off"));
  expect_error_line(run("convert @box.off @other/box.off -o @out/"), "would both be written to");
  expect_error_line(run("convert @box.off @sphere.off -o @x.ply"), "need a result folder");
  expect_error_line(run("convert @box.off @sphere.off -o -"), "need a result folder");
  const std::string before = text_of(at("box.off"));
  expect_error_line(run("perturb @box.off -o @box.off --noise 0.1"), "--replace");
  expect_error_line(run("perturb @box.off -o @other/../box.off --noise 0.1"), "--replace");
  expect_error_line(run("perturb @box.off @sphere.off -o @. --noise 0.1"), "--replace");
  EXPECT_EQ(text_of(at("box.off")), before);
  EXPECT_EQ(run("perturb @box.off -o @box.off --noise 0.1 --replace").status, 0);
  EXPECT_NE(text_of(at("box.off")), before);
}

TEST_F(ShapeFileCommands, AcceptStandardInputAndOutput) {
  ASSERT_EQ(run("sdf @box.off --method cone_sdf -o @box.csv").status, 0);
  EXPECT_EQ(run("sdf - --method cone_sdf -o - < @box.off").output, text_of(at("box.csv")));
  ASSERT_EQ(run("convert @box.off -o @box.ply").status, 0);
  EXPECT_EQ(run("convert - -o - --output-format ply < @box.off").output, text_of(at("box.ply")));
  EXPECT_THAT(run("info - < @box.off").output, HasSubstr("volume                  6\n"));
  write_text(at("points"), "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  EXPECT_THAT(run("convert - -o - --input-format xyz < @points").output, StartsWith("OFF\n4 0 0\n"));
  EXPECT_THAT(run("convert @points -o - --input-format xyz").output, StartsWith("OFF\n4 0 0\n"));
  expect_error_line(run("convert - -o - < @points"), "standard input");
  expect_error_line(run("convert - -o -"), "standard input is empty");
  expect_error_line(run("info - -"), "once only");
}

TEST_F(ShapeFileCommands, InfoPrintsBoundingBoxVolumeGenusAndWinding) {
  const auto info = [&](const std::string& name, const Shape& shape) {
    write_off(at(name), shape);
    return nlohmann::json::parse(run("info --format json @" + name).output);
  };
  const Shape box = test::box({1, 2, 3}, 2);
  const auto of_box = info("b.off", box);
  EXPECT_NEAR(of_box["volume"].get<double>(), 6, 1e-12);
  EXPECT_EQ(of_box["genus"], 0);
  EXPECT_EQ(of_box["winding"], "outward");
  EXPECT_EQ(of_box["bounding_box"]["max"][2].get<double>() - of_box["bounding_box"]["min"][2].get<double>(), 3);
  const auto turned = info("turned.off", test::flipped(box));
  EXPECT_NEAR(turned["volume"].get<double>(), 6, 1e-12);
  EXPECT_EQ(turned["winding"], "inward");
  Shape two = box;  // touching in a corner: two parts without handles
  two.vertices.conservativeResize(2 * box.vertices.rows(), 3);
  two.vertices.bottomRows(box.vertices.rows()) = -box.vertices;
  two.triangles.conservativeResize(2 * box.triangles.rows(), 3);
  const auto n = static_cast<std::int32_t>(box.vertices.rows());
  two.triangles.bottomRows(box.triangles.rows()) = test::flipped(box).triangles.array() + n;
  const Eigen::RowVector3d corner = box.vertices.colwise().maxCoeff();
  two.vertices.topRows(n).rowwise() -= corner;
  two.vertices.bottomRows(n).rowwise() += corner;
  const auto of_two = info("two.off", two);
  EXPECT_EQ(of_two["genus"], 0);
  EXPECT_NEAR(of_two["volume"].get<double>(), 12, 1e-12);
  Shape reversed_box = test::flipped(test::box({1, 1, 1}, 1));
  reversed_box.vertices.array() += 9;
  const auto mixed = info("mixed.off", test::joined({box, reversed_box}));
  EXPECT_EQ(mixed["winding"], "mixed");
  EXPECT_NEAR(mixed["volume"].get<double>(), 7, 1e-12);
  Shape open = box;
  open.triangles = box.triangles.bottomRows(box.triangles.rows() - 1).eval();
  const auto of_open = info("open.off", open);
  EXPECT_TRUE(of_open["volume"].is_null());
  EXPECT_TRUE(of_open["genus"].is_null());
  EXPECT_EQ(of_open["winding"], "consistent");
  Shape cloud = box;
  cloud.triangles.resize(0, 3);
  EXPECT_EQ(info("cloud.off", cloud)["winding"], "none");
}

TEST_F(ShapeFileCommands, InfoListsSeveralShapesInTheOrderOfArguments) {
  const auto infos = nlohmann::json::parse(run("info --format json @sphere.off @box.off").output);
  ASSERT_EQ(infos.size(), 2U);
  EXPECT_EQ(infos[0]["file"], at("sphere.off").string());
  EXPECT_EQ(infos[1]["vertices"], 8);
}

TEST_F(ShapeFileCommands, WritePicturesOfTheRequestedSizeAndView) {
  const auto picture = [&](const std::string& more) {
    succeeded(run("sdf @box.off --method cone_sdf --replace -o @x.png " + more));
    return text_of(at("x.png"));
  };
  const std::string defaults = picture("");
  EXPECT_EQ(picture("--up y --picture-size 640x480"), defaults);
  EXPECT_EQ(picture("--picture-size 300x200").substr(16, 8), std::string("\0\0\x01\x2c\0\0\0\xc8", 8));
  EXPECT_NE(picture("--view 1,0,0"), defaults);
  EXPECT_NE(picture("--up z"), defaults);
  EXPECT_NE(picture("--view 1,0,0 --up z"), picture("--view 1,0,0"));
  EXPECT_NE(picture("--view 0,1,0"), defaults);
  for (const char* wrong : {"--picture-size 300", "--picture-size 0x5", "--picture-size 1e9x1", "--view up",
                            "--view 1,2", "--view 0,0,0"}) {
    EXPECT_EQ(run(std::string("sdf @box.off --method cone_sdf -o @x.png ") + wrong).status, 2) << wrong;
  }
}

}  // namespace

}  // namespace shapegauge::test_command_line
