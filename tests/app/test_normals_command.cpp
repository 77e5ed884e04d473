// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/datasets/files/csv.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using test::text_of;
using testing::HasSubstr;
using testing::StartsWith;

class NormalsCommand : public CommandTest {
 protected:
  void SetUp() override {
    write_off(at("mesh.off"), mesh);
    write_off(at("cloud.off"), cloud);
  }
  [[nodiscard]] Outcome normals(const std::string& input, const std::string& more, const std::string& output) const {
    return run(fmt::format("normals {} {} --replace -o {}", quoted(input), more, quoted(output)));
  }

  Shape mesh = test::flipped(test::sphere(10, 2));
  Shape cloud = test::random_points(test::sphere(10, 4), 3000, 1);
};

TEST_F(NormalsCommand, WritesOutwardNormalsAtFacesToCsv) {
  const Outcome outcome = succeeded(normals("mesh.off", "--at faces --offset 0.02", "x.csv"));
  EXPECT_EQ(outcome.output + outcome.errors, "");
  const std::vector<CsvRow> rows = parse_csv(text_of(at("x.csv")), "x.csv");
  const Samples samples = sample_shape(mesh, SampleSite::faces);
  const Points expected = offset_sdf(mesh, samples, {.offset = 0.02}).normals;
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(expected.rows()) + 1);
  EXPECT_EQ(rows[0].cells, (std::vector<std::string>{"index", "nx", "ny", "nz", "weight"}));
  for (Eigen::Index i = 0; i < expected.rows(); ++i) {
    const std::vector<std::string>& cells = rows[static_cast<std::size_t>(i) + 1].cells;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(std::stod(cells[static_cast<std::size_t>(k) + 1]), expected(i, k));
    EXPECT_EQ(std::stod(cells[4]), samples.weights[i]);
    EXPECT_GT(expected.row(i).dot(samples.points.row(i)), 0);
  }
}

TEST_F(NormalsCommand, WritesCloudsWithNormalsInEveryFormat) {
  const Outcome outcome = succeeded(normals("cloud.off", "--offset auto", "x.ply"));
  EXPECT_THAT(outcome.errors, StartsWith("shapegauge: offset: "));
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
  const Shape read = read_shape(at("x.ply"));
  const Shape written = read_shape(at("cloud.off"));
  const Points expected =
      offset_sdf(written, sample_shape(written, SampleSite::vertices), {.offset = automatic_offset(written).offset})
          .normals;
  EXPECT_LT((read.normals - expected).cwiseAbs().maxCoeff(), 1e-12);
  ASSERT_EQ(normals("cloud.off", "--offset auto", "x.xyz").status, 0);
  EXPECT_LT((read_shape(at("x.xyz")).normals - expected).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(read_shape(at("x.xyz")).vertices, written.vertices);
  ASSERT_EQ(normals("cloud.off", "--offset auto", "x.npy").status, 0);
  EXPECT_THAT(text_of(at("x.npy")), HasSubstr("'shape': (3000, 3)"));
}

TEST_F(NormalsCommand, WritesOutwardNormalsOfAPointCloudByDefault) {
  ASSERT_EQ(normals("cloud.off", "", "x.ply").status, 0);
  const Shape read = read_shape(at("x.ply"));
  EXPECT_GT((read.normals.cwiseProduct(read.vertices).rowwise().sum().array() > 0).cast<double>().mean(), 0.99);
}

TEST_F(NormalsCommand, WarnsOfSamplesWithTheOutsideOnBothSides) {
  const Outcome outcome = succeeded(normals("cloud.off", "--offset 0.01", "x.ply"));
  const Shape read = read_shape(at("x.ply"));
  const auto inward = (read.normals.cwiseProduct(read.vertices).rowwise().sum().array() < 0).count();
  ASSERT_GT(inward, 1000) << "about half of 3000";
  const std::size_t begin = outcome.errors.find("of 3000 samples have the outside on both sides");
  ASSERT_NE(begin, std::string::npos) << outcome.errors;
  const long counted = std::stol(outcome.errors.substr(outcome.errors.rfind(' ', begin - 2)));
  EXPECT_GE(counted, 1.9 * inward) << "by chance, as many point outward as inward";
  EXPECT_THAT(normals("mesh.off", "", "x.ply").errors, testing::Not(HasSubstr("both sides")));
}

TEST_F(NormalsCommand, WarnsIfSurfaceGapsAreWiderThanTheOffset) {
  const Outcome outcome = succeeded(normals("cloud.off", "--offset 0.01", "x.csv"));
  EXPECT_THAT(outcome.errors, HasSubstr("the offset is smaller than the gaps of the shape (4."));
  EXPECT_THAT(outcome.errors, HasSubstr(" or --offset auto\n"));
  // The recommended offset suffices and is not much wider than the gaps.
  const std::string option = "use --offset ";
  const std::size_t begin = outcome.errors.find(option);
  ASSERT_NE(begin, std::string::npos) << outcome.errors;
  const double enough = std::stod(outcome.errors.substr(begin + option.size()));
  EXPECT_GT(enough, 0.04);
  EXPECT_LT(enough, 0.06);
  const Outcome again = normals("cloud.off", fmt::format("--offset {}", enough), "x.csv");
  EXPECT_THAT(again.errors, testing::Not(HasSubstr("gaps")));
}

TEST_F(NormalsCommand, DenoiseOptionImprovesTheNormalsOfANoisyMesh) {
  const Shape fine = test::sphere(10, 4);
  RandomNumbers random(1);
  write_off(at("clean.off"), fine);
  write_off(at("noisy.off"), vertex_noise(fine, {.amplitude = 0.01}, random));
  EXPECT_THAT(normals("clean.off", "--denoise", "clean.xyz").errors, HasSubstr("not clearly noisy"));
  EXPECT_THAT(normals("noisy.off", "--denoise", "denoised.xyz").errors, HasSubstr("smoothed with a pass band"));
  EXPECT_EQ(normals("noisy.off", "--offset 0.03", "noisy.xyz").status, 0);
  const auto mean_cosine = [&](const std::string& name) {
    const Shape result = read_shape(at(name));
    double sum = 0;
    for (Eigen::Index i = 0; i < fine.vertices.rows(); ++i) sum += result.normals.row(i).dot(fine.vertices.row(i)) / 10;
    return sum / static_cast<double>(fine.vertices.rows());
  };
  EXPECT_GT(mean_cosine("clean.xyz"), 0.9998);
  EXPECT_GT(mean_cosine("denoised.xyz"), 0.99);
  EXPECT_LT(mean_cosine("noisy.xyz"), 0.99);
}

TEST_F(NormalsCommand, RejectsOffsetsOutOfRangeMissingFilesAndPngOutput) {
  for (const char* offset : {"0", "-1", "nan", "1.5", "automatic"}) {
    const Outcome outcome = normals("mesh.off", std::string("--offset ") + offset, "x.csv");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("offset")) << offset;
  }
  EXPECT_EQ(normals("mesh.off", "", "x.png").status, 2);
  EXPECT_EQ(normals("absent.off", "", "x.csv").status, 2);
}

}  // namespace

}  // namespace shapegauge::test_command_line
