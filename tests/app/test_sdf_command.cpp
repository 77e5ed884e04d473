// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/datasets/files/csv.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::StartsWith;

class SdfCommand : public CommandTest {
 protected:
  void SetUp() override { write_off(at("sphere.off"), shape); }
  [[nodiscard]] Outcome sdf(const std::string& more) const { return run("sdf @sphere.off " + more); }

  Shape shape = test::sphere(10, 3);
};

TEST_F(SdfCommand, WritesSdfValuesInMeshUnitsAndVertexOrder) {
  const Outcome outcome = succeeded(sdf("--method cone_sdf --at vertices -o @x.csv"));
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(outcome.errors, "");
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const ConeSdfResult expected = cone_sdf(shape, samples, {});
  const std::vector<CsvRow> rows = parse_csv(text_of(at("x.csv")), "x.csv");
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(expected.values.size()) + 1);
  EXPECT_EQ(rows[0].cells, (std::vector<std::string>{"index", "sdf", "weight"}));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto sample = static_cast<Eigen::Index>(i - 1);
    EXPECT_EQ(rows[i].cells[0], std::to_string(sample));
    EXPECT_EQ(std::stod(rows[i].cells[1]), expected.values[sample]);
    EXPECT_EQ(std::stod(rows[i].cells[2]), samples.weights[sample]);
  }
}

TEST_F(SdfCommand, PrintsASummaryOfTheOffsetSdfByDefault) {
  const Outcome outcome = succeeded(sdf(""));
  EXPECT_THAT(outcome.output, StartsWith("shape "));
  EXPECT_EQ(outcome.output, sdf("--method offset_sdf --offset 5% --summary").output);
  EXPECT_EQ(sdf("--method cone_sdf").output, sdf("--method cone_sdf --summary").output);
}

TEST_F(SdfCommand, OffsetSdfOfASphereIsItsDiameter) {
  ASSERT_EQ(sdf("--method offset_sdf --offset 0.02 -o @x.csv").status, 0);
  // The icosphere is a little thinner than the sphere, and its flat faces are nearer to the centre than its corners.
  const std::vector<CsvRow> rows = parse_csv(text_of(at("x.csv")), "x.csv");
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(shape.triangles.rows()) + 1);
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_NEAR(std::stod(rows[i].cells[1]), 20, 0.1) << i;
}

TEST_F(SdfCommand, ReportsOutliersAndRemovesThemOnRequest) {
  const Shape cloud = test::random_points(shape, 3000, 1);
  Shape spoilt = cloud;
  spoilt.vertices.conservativeResize(3002, Eigen::NoChange);
  spoilt.vertices.bottomRows(2) << 100, 0, 0, 0, -200, 0;
  write_off(at("spoilt.off"), spoilt);
  const auto outcome_of = [&](const std::string& options) {
    return run("sdf @spoilt.off --method offset_sdf --replace -o @x.csv " + options);
  };
  EXPECT_THAT(outcome_of("--offset 0.05").errors, HasSubstr("warning: 2 of 3002 points are outliers"));
  for (const char* options : {"--offset 0.05 --remove-outliers", "--offset auto"}) {
    EXPECT_THAT(outcome_of(options).errors, HasSubstr("2 of 3002 points are outliers")) << options;
    EXPECT_THAT(outcome_of(options).errors, testing::Not(HasSubstr("warning"))) << options;
    const std::vector<CsvRow> rows = parse_csv(text_of(at("x.csv")), "x.csv");
    ASSERT_EQ(rows.size(), 3001U);
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GT(std::stod(rows[i].cells[1]), 15) << i;
  }
}

TEST_F(SdfCommand, WritesValuesAtThePointsOfACloudInEveryFormat) {
  const Shape cloud = test::random_points(shape, 500, 1);
  std::string lines = "500\n";
  for (const auto& point : cloud.vertices.rowwise()) {
    lines += fmt::format("{} {} {}\n", point[0], point[1], point[2]);
  }
  write_text(at("cloud.pts"), lines);
  const std::string command = "sdf @cloud.pts --method offset_sdf --offset 0.2 -o @";
  for (const char* file : {"x.csv", "x.npy", "x.ply", "x.png"}) {
    const Outcome outcome = succeeded(run(command + file));
    EXPECT_EQ(outcome.errors, "");
  }
  const std::vector<CsvRow> rows = parse_csv(text_of(at("x.csv")), "x.csv");
  ASSERT_EQ(rows.size(), 501U);
  const Samples samples = sample_shape(cloud, SampleSite::vertices);
  const Eigen::VectorXd expected = offset_sdf(cloud, samples, {.offset = 0.2}).values;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto sample = static_cast<Eigen::Index>(i - 1);
    EXPECT_EQ(std::stod(rows[i].cells[1]), expected[sample]);
    EXPECT_EQ(std::stod(rows[i].cells[2]), samples.weights[sample]);
  }
  EXPECT_EQ(read_shape(at("x.ply")).vertices, cloud.vertices);
  ASSERT_EQ(run(command + "v.csv --at vertices").status, 0);
  EXPECT_EQ(text_of(at("v.csv")), text_of(at("x.csv")));
}

TEST_F(SdfCommand, TimingsFileContainsSecondsAndNumbersOfSamples) {
  ASSERT_EQ(sdf("--method offset_sdf -o @x.ply --timings @t.json").status, 0);
  const auto timings = nlohmann::json::parse(text_of(at("t.json")));
  for (const char* key : {"read_seconds", "build_seconds", "query_seconds"}) EXPECT_GE(timings.at(key), 0) << key;
  EXPECT_EQ(timings["samples"]["total"], shape.triangles.rows());
  EXPECT_EQ(timings["samples"]["direct"].get<int>() + timings["samples"]["searched"].get<int>(),
            shape.triangles.rows());
  EXPECT_EQ(timings["shape"]["closed"], true);
  EXPECT_EQ(timings["shape"]["triangles"], shape.triangles.rows());
}

TEST_F(SdfCommand, TimingsFileContainsTheSizeOfTheLargestGap) {
  const Shape open{shape.vertices, shape.triangles.bottomRows(shape.triangles.rows() - 1)};
  write_off(at("open.off"), open);
  ASSERT_EQ(run("sdf @open.off --method offset_sdf --offset 0.2 -o @x.csv --timings @t.json").status, 0);
  const auto offset = nlohmann::json::parse(text_of(at("t.json"))).at("offset");
  EXPECT_EQ(offset["offset"], 0.2);
  EXPECT_EQ(offset["automatic"], false);
  // The gap is as wide as the inscribed circle: its radius is twice the area by the perimeter. The grid of distances
  // is accurate to half a cell.
  const Eigen::Vector3d a = shape.vertices.row(shape.triangles(0, 0));
  const Eigen::Vector3d b = shape.vertices.row(shape.triangles(0, 1));
  const Eigen::Vector3d c = shape.vertices.row(shape.triangles(0, 2));
  const double radius = (b - a).cross(c - a).norm() / ((b - a).norm() + (c - b).norm() + (a - c).norm());
  EXPECT_NEAR(offset["gap_fraction"].get<double>() * bounding_box_diagonal(open), radius,
              0.0055 * bounding_box_diagonal(open));
}

TEST_F(SdfCommand, PrintsSummariesInTheRequestedFormatAndUnit) {
  const auto json =
      nlohmann::json::parse(sdf("--method inscribed_ball --summary --format json --unit cm --below 210mm").output);
  EXPECT_NEAR(json["percentiles"]["50"].get<double>(), 20, 0.5);
  EXPECT_NEAR(json["area"].get<double>(), 4 * 3.14159 * 100, 15);
  EXPECT_DOUBLE_EQ(json["below"]["threshold"], 21);
  EXPECT_EQ(json["below"]["percent"], 100);
  EXPECT_EQ(json["unit"], "cm");
  const std::string csv = sdf("--method ball --summary --format csv --below 1").output;
  const std::vector<CsvRow> rows = parse_csv(csv, "summary");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].cells.back(), "0.00");
  EXPECT_THAT(sdf("--method cone_sdf --summary --unit mm").output, HasSubstr("median (mm)"));
}

TEST_F(SdfCommand, RejectsAnotherUnitThanMetresForGltf) {
  const std::string absent = "sdf " + quoted("absent.glb") + " --method inscribed_ball --summary --below 1.2";
  const std::string others = " " + quoted("absent.glb") + " -o x.ply --offset 1mm";
  const std::string segment = "segment --method paper" + others;
  expect_error_lines({{absent + " --unit mm", "metres"},
                      {absent + "mm", "No such file"},
                      {"normals" + others + " --unit mm", "metres"},
                      {"normals" + others, "No such file"},
                      {segment + " --unit mm", "metres"},
                      {segment, "No such file"}});
}

TEST_F(SdfCommand, AcceptsOffsetsAsLengthFractionOrPercentage) {
  const double diagonal = bounding_box_diagonal(shape);
  ASSERT_EQ(sdf("--method offset_sdf --unit cm --offset 10mm -o @length.npy").status, 0);
  ASSERT_EQ(sdf(fmt::format("--method offset_sdf --offset {} -o @fraction.npy", 1 / diagonal)).status, 0);
  EXPECT_TRUE(text_of(at("length.npy")) == text_of(at("fraction.npy")));
  ASSERT_EQ(sdf("--method offset_sdf --unit cm --offset 3% -o @percent.npy").status, 0);
  ASSERT_EQ(sdf("--method offset_sdf --offset 0.03 -o @three.npy").status, 0);
  EXPECT_TRUE(text_of(at("percent.npy")) == text_of(at("three.npy")));
}

TEST_F(SdfCommand, PicturesHaveALegendAndTheRequestedRange) {
  const std::string picture = "--method cone_sdf --picture-size 640x480 -o @";
  ASSERT_EQ(sdf(picture + "with.png --unit mm").status, 0);
  ASSERT_EQ(sdf(picture + "without.png --no-legend").status, 0);
  EXPECT_NE(text_of(at("with.png")), text_of(at("without.png")));
  ASSERT_EQ(sdf("--method cone_sdf --unit mm --range 1,40 --scale log --below 1cm -o @x.ply").status, 0);
  EXPECT_THAT(text_of(at("x.ply")),
              HasSubstr("comment SDF (mm): colours (viridis) from 1 to 40, logarithmic; less than 10 is red\n"));
  EXPECT_EQ(read_shape(at("x.ply")).triangles, shape.triangles);
}

TEST_F(SdfCommand, CsvColumnIsNamedSdfOrInscribedBallByMethod) {
  ASSERT_EQ(sdf("--method ball -o @ball.csv").status, 0);
  EXPECT_THAT(text_of(at("ball.csv")), testing::StartsWith("index,inscribed_ball,weight\n"));
  ASSERT_EQ(sdf("--method cone_sdf -o @cone.csv").status, 0);
  EXPECT_THAT(text_of(at("cone.csv")), testing::StartsWith("index,sdf,weight\n"));
}

TEST_F(SdfCommand, PlotsAHistogramOfSdfValues) {
  ASSERT_EQ(sdf("--method cone_sdf --unit mm --below 3 --plot @x.svg").status, 0);
  EXPECT_THAT(text_of(at("x.svg")),
              testing::AllOf(HasSubstr(">SDF (mm)<"), HasSubstr(">3 mm<"), HasSubstr(">sphere.off<")));
}

TEST_F(SdfCommand, WarnsOfHollowBodies) {
  write_off(at("sphere.off"), test::joined({shape, test::flipped(test::sphere(8, 3))}));
  EXPECT_THAT(sdf("--method offset_sdf -o @x.csv").errors,
              testing::AllOf(HasSubstr("warning"), HasSubstr("hollow"), HasSubstr("hull")));
  const Outcome outcome = sdf("--method inscribed_ball --summary --format json");
  EXPECT_THAT(outcome.errors, testing::AllOf(HasSubstr("wall"), testing::Not(HasSubstr("warning"))));
  EXPECT_NEAR(nlohmann::json::parse(outcome.output)["percentiles"]["50"].get<double>(), 2, 0.2);
}

TEST_F(SdfCommand, WarnsOfSamplesWithoutAnSdfValue) {
  write_text(at("sphere.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Outcome outcome = succeeded(sdf("--method cone_sdf -o @x.csv"));
  EXPECT_EQ(
      outcome.errors,
      "shapegauge: warning: 1 of 1 samples missing: parts that are open or inside out (offset_sdf measures these), "
      "triangles without area, vertices without triangles, points without normals or, for gaps, nothing opposite\n");
  EXPECT_THAT(text_of(at("x.csv")), HasSubstr("0,nan,0.5"));
}

TEST_F(SdfCommand, RejectsUnusableShapesAndInvalidOptionValues) {
  write_text(at("cloud.off"), "OFF\n2 0 0\n0 0 0\n1 0 0\n");
  write_text(at("point.xyz"), "1 2 3\n1 2 3\n");
  write_text(at("nan.xyz"), "1 2 3\n1 2 nan\n");
  write_text(at("nan.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n");
  const std::string good = "sdf " + quoted("sphere.off") + " ";
  const std::string out = " -o " + quoted("x.csv") + " ";
  const std::vector<UnusableCall> cases{
      {"sdf /nowhere.off --method cone_sdf" + out, "/nowhere.off"},
      {"sdf " + quoted("cloud.off") + " --method cone_sdf" + out, "cloud.off: the conventional SDF needs triangles"},
      {"sdf " + quoted("cloud.off") + " --method cone_sdf --engine cgal" + out,
       "cloud.off: the conventional SDF needs triangles"},
      {"sdf " + quoted("point.xyz") + " --method offset_sdf" + out, "point.xyz: the shape has no usable extent"},
      {"sdf " + quoted("nan.xyz") + " --method offset_sdf" + out, "nan.xyz:2"},
      {"sdf " + quoted("nan.off") + " --method cone_sdf" + out, "nan.off:5"},
      {good + "--method heat" + out, "--method"},
      {good + "--method offst_sdf" + out, "did you mean \"offset_sdf\"?"},
      {good + "--method cone_sdf -o x.xlsx", "must end in .csv"},
      {good + "--method cone_sdf -o /nowhere/x.csv", "/nowhere/x.csv"},
      {good + "--method offset_sdf --offset 0" + out, "offset"},
      {good + "--method offset_sdf --offset nan" + out, "offset"},
      {good + "--method offset_sdf --offset 1mm" + out, "--unit"},
      {good + "--method offset_sdf --offset 3m --unit mm" + out, "diagonal"},
      {good + "--method offset_sdf --offset 0.5 --unit mm" + out, "write 0.5mm or 50%"},
      {good + "--method offset_sdf --offset 0.05 --unit mm" + out, "write 0.05mm or 5%"},
      {good + "--method offset_sdf --offset half%" + out, "%"},
      {good + "--method cone_sdf --below 2parsecs" + out, "--below"},
      {good + "--method cone_sdf --range 4" + out, "--range"},
      {good + "--method cone_sdf --range 4,1" + out, "--range"},
      {good + "--method cone_sdf --range 0,1 --scale log" + out, "--range"},
      {good + "--method cone_sdf --separation-angle-degrees 30" + out, "--separation-angle-degrees"},
      {good + "--method inscribed_ball --separation-angle-degrees 180" + out, "angle"},
      {good + "--method cone_sdf --plot x.eps", ".svg, .pdf or .png"},
      {good + "--method cone_sdf --rays 0" + out, "rays"},
      {good + "--method cone_sdf --opening-angle-degrees 400" + out, "angle"},
      {good + "--method cone_sdf --engine cgal --at vertices" + out, "faces only"},
      {good + "--method cone_sdf --accuracy fine" + out, "--accuracy does not apply to --method cone_sdf"},
      {good + "--method cone_sdf --offset 0.1" + out, "--offset does not apply to --method cone_sdf"},
      {good + "--method offset_sdf --rays 3" + out, "--rays does not apply to --method offset_sdf"}};
  expect_error_lines(cases);
}

}  // namespace

}  // namespace shapegauge::test_command_line
