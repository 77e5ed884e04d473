// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using test::text_of;
using testing::HasSubstr;

class PerturbCommand : public CommandTest {
 protected:
  void SetUp() override { write_off(at("sphere.off"), shape); }
  [[nodiscard]] Outcome perturb(const std::string& output, const std::string& more) const {
    return run("perturb @sphere.off --replace -o " + quoted(output) + " " + more);
  }

  Shape shape = test::sphere(10, 3);  // 1280 faces
};

TEST_F(PerturbCommand, DecimatesBeforeRemovingFacesDespiteTheOrderOfOptions) {
  const Outcome outcome =
      succeeded(perturb("x.off", "--remove-faces 0.5 --noise 0.01 --decimate 400 --flip 1 --motion 2"));
  EXPECT_EQ(outcome.output + outcome.errors, "");
  EXPECT_NEAR(static_cast<double>(read_shape(at("x.off")).triangles.rows()), 200, 1);
}

TEST_F(PerturbCommand, WarnsIfDecimationStopsAboveTheRequestedNumberOfFaces) {
  const Outcome outcome = succeeded(perturb("x.off", "--decimate 1"));
  const auto left = read_shape(at("x.off")).triangles.rows();
  EXPECT_GT(left, 1);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("decimated to " + std::to_string(left) + " faces instead of 1"));
  EXPECT_EQ(perturb("x.off", "--decimate 100").errors, "");
}

TEST_F(PerturbCommand, OutputDependsOnTheSeed) {
  ASSERT_EQ(perturb("a.off", "--noise 0.01 --seed 4").status, 0);
  ASSERT_EQ(perturb("b.off", "--noise 0.01 --seed 4").status, 0);
  ASSERT_EQ(perturb("c.off", "--noise 0.01 --seed 5").status, 0);
  EXPECT_EQ(text_of(at("a.off")), text_of(at("b.off")));
  EXPECT_NE(text_of(at("a.off")), text_of(at("c.off")));
}

TEST_F(PerturbCommand, WarnsOfCoordinatesTooLargeForStl) {
  Shape far = shape;
  far.vertices.rowwise() += Eigen::RowVector3d(5e5, 4.5e6, 100);
  write_off(at("far.off"), far);
  const Outcome converted = succeeded(run("convert @far.off -o @far.stl"));
  EXPECT_THAT(converted.errors, HasSubstr("single precision of STL"));
  EXPECT_EQ(run("convert @far.off -o @far.ply").errors, "");
  EXPECT_EQ(perturb("near.stl", "--flip 1").errors, "");
}

TEST_F(PerturbCommand, KeepsTheUpAxisStatedByTheInput) {
  write_off(at("sphere.off"), shape, "# up: -x");
  for (const char* name : {"x.off", "x.obj", "sphere.off"}) {
    ASSERT_EQ(perturb(name, "--noise 0.01").status, 0);
    EXPECT_THAT(text_of(at(name)), testing::EndsWith("\n# up: -x\n")) << name;
    EXPECT_EQ(read_shape(at(name)).triangles.rows(), shape.triangles.rows()) << name;
  }
  ASSERT_EQ(run("convert @sphere.off -o @y.off").status, 0);
  EXPECT_THAT(text_of(at("y.off")), testing::EndsWith("\n# up: -x\n"));
  ASSERT_EQ(run("convert @sphere.off -o @y.ply").status, 0);
  EXPECT_EQ(read_shape(at("y.ply")).triangles.rows(), shape.triangles.rows());
}

TEST_F(PerturbCommand, PointsOptionWritesTheRequestedNumberOfPoints) {
  ASSERT_EQ(perturb("x.ply", "--points 50 --holes 1 --hole-radius 0.02").status, 0);
  EXPECT_THAT(text_of(at("x.ply")), HasSubstr("element vertex 50\n"));
}

TEST_F(PerturbCommand, VertexCloudOptionWritesTheVerticesAsACloud) {
  ASSERT_EQ(perturb("x.ply", "--vertex-cloud").status, 0);
  EXPECT_TRUE(is_cloud(read_shape(at("x.ply"))));
  EXPECT_EQ(read_shape(at("x.ply")).vertices, shape.vertices);
}

TEST_F(PerturbCommand, AddsUniformNoiseByDefault) {
  ASSERT_EQ(perturb("a.off", "--noise 0.01").status, 0);
  ASSERT_EQ(perturb("b.off", "--noise 0.01 --noise-distribution uniform").status, 0);
  ASSERT_EQ(perturb("c.off", "--noise 0.01 --noise-distribution gaussian").status, 0);
  EXPECT_EQ(text_of(at("a.off")), text_of(at("b.off")));
  EXPECT_NE(text_of(at("a.off")), text_of(at("c.off")));
}

TEST_F(PerturbCommand, RejectsMissingPerturbationsAndAmountsOutOfRange) {
  EXPECT_THAT(perturb("x.off", "").errors, HasSubstr("no perturbation given"));
  EXPECT_THAT(perturb("x.xlsx", "--noise 0.1").errors, HasSubstr("cannot write"));
  EXPECT_THAT(perturb("x.off", "--noise -1").errors, HasSubstr("--noise is -1"));
  EXPECT_EQ(perturb("x.off", "--remove-faces 1").status, 2);
  EXPECT_EQ(perturb("x.off", "--noise 0.1 --seed -1").status, 2);
  EXPECT_EQ(perturb("x.off", "--hole-radius 0.1").status, 2) << "without --holes";
}

}  // namespace

}  // namespace shapegauge::test_command_line
