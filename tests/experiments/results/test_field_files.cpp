// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/experiments/results/field_files.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using test::text_of;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class FieldFiles : public testing::Test {
 protected:
  FieldFiles() : shape(test::box({1, 1, 1}, 1)), samples(sample_shape(shape, SampleSite::faces)) {
    values.setLinSpaced(shape.triangles.rows(), 0.1, 1);
    values[1] = std::numeric_limits<double>::quiet_NaN();
  }
  std::string written(const std::string& name) {
    const auto path = folder.path() / name;
    field_file_writer(path, {.value_name = value_name})(path, shape, samples, values);
    return text_of(path);
  }

  test::TemporaryFolder folder;
  Shape shape;
  Samples samples;
  Eigen::VectorXd values;
  std::string value_name = "sdf";
};

TEST_F(FieldFiles, CsvFileHasOneRowPerSample) {
  const std::string text = written("x.csv");
  EXPECT_THAT(text, StartsWith("index,sdf,weight\n0,0.1,0.5\n1,nan,0.5\n2,"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 12);
}

TEST_F(FieldFiles, CsvFileGivesThePolygonOfEachSample) {
  shape.polygons.count = 6;
  for (int i = 0; i < 12; ++i) shape.polygons.of_triangle.push_back(i / 2);
  EXPECT_THAT(written("x.csv"), StartsWith("index,sdf,weight,polygon\n0,0.1,0.5,0\n1,nan,0.5,0\n2,"));
  EXPECT_THAT(written("x.csv"), EndsWith("\n11,1,0.5,5\n"));
  normal_file_writer("n.csv")(folder.path() / "n.csv", shape, samples, samples.normals);
  EXPECT_THAT(text_of(folder.path() / "n.csv"), StartsWith("index,nx,ny,nz,weight,polygon\n0,"));
  samples = sample_shape(shape, SampleSite::vertices);
  values.setLinSpaced(shape.vertices.rows(), 0.1, 1);
  EXPECT_THAT(written("v.csv"), StartsWith("index,sdf,weight\n")) << "vertices are those of the file";
}

TEST_F(FieldFiles, NpyFileContainsTheValues) {
  const std::string bytes = written("x.npy");
  EXPECT_THAT(bytes, StartsWith("\x93NUMPY"));
  EXPECT_THAT(bytes, HasSubstr("'descr': '<f8', 'fortran_order': False, 'shape': (12,)"));
  ASSERT_EQ(bytes.size() % 64, 12 * sizeof(double) % 64);
  double last = 0;
  std::memcpy(&last, bytes.data() + bytes.size() - sizeof(double), sizeof(double));
  EXPECT_EQ(last, 1);
}

TEST_F(FieldFiles, AreWrittenAsPlyAndPng) {
  const std::string ply = written("x.PLY");
  EXPECT_THAT(ply, StartsWith("ply\n"));
  EXPECT_THAT(ply, HasSubstr(" sdf\n"));
  EXPECT_THAT(written("x.png"), StartsWith("\x89PNG"));
}

TEST_F(FieldFiles, CsvAndPlyFilesNameTheField) {
  value_name = "inscribed_ball";
  EXPECT_THAT(written("x.csv"), StartsWith("index,inscribed_ball,weight\n"));
  EXPECT_THAT(written("x.ply"), HasSubstr("property double inscribed_ball\n"));
}

TEST_F(FieldFiles, RejectAnUnknownExtension) {
  EXPECT_THAT(test::input_error_of([] { field_file_writer("x.xlsx"); }),
              HasSubstr("must end in .csv, .npy, .ply or .png"));
}

}  // namespace

}  // namespace shapegauge
