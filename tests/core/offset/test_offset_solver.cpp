#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/offset/offset_solver.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/core/sdf/crevice_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(OffsetSolver, GivesTheSameBytesInAnyOrderAndOnAnyThreads) {
  const Shape shape = test::of_diagonal_1(test::star());
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const OffsetAnswers forth = answer_by_grid(shape, samples.points, samples.normals, {.parallel = false});
  const OffsetAnswers back = answer_by_grid(shape, samples.points.colwise().reverse(),
                                            samples.normals.colwise().reverse(), {.parallel = true});
  EXPECT_EQ(forth.values, back.values.reverse());
  EXPECT_EQ(forth.directions, back.directions.colwise().reverse());
}

TEST(OffsetSolver, AnswersOfASampleDoNotDependOnTheOthers) {
  // Arms between which samples of a block have both sides covered, and sites far and near.
  for (const test::OffsetCase& one : test::offset_cases()) {
    const Samples samples = sample_shape(one.shape, SampleSite::faces);
    const OffsetGridOptions options{.offset = one.offset, .parallel = false};
    const OffsetAnswers all = answer_by_grid(one.shape, samples.points, samples.normals, options);
    std::vector<std::int32_t> few;
    for (Eigen::Index f = 0; f < samples.points.rows(); f += 7) few.push_back(static_cast<std::int32_t>(f));
    const OffsetAnswers alone =
        answer_by_grid(one.shape, samples.points(few, Eigen::all), samples.normals(few, Eigen::all), options, few);
    EXPECT_EQ(alone.values, all.values(few)) << one.name;
    EXPECT_EQ(alone.directions, all.directions(few, Eigen::all)) << one.name;
    for (std::size_t i = 0; i < few.size(); ++i) {
      ASSERT_EQ(alone.outcomes[i], all.outcomes[static_cast<std::size_t>(few[i])]) << one.name << ' ' << few[i];
    }
  }
}

TEST(OffsetSolver, DecidesTiesByTheNormal) {
  // Of an open sheet both sides are exterior, and as near.
  Shape sheet;
  sheet.vertices.resize(4, 3);
  sheet.vertices << 0, 0, 0, 0.7, 0, 0, 0.7, 0.7, 0, 0, 0.7, 0;
  sheet.triangles.resize(2, 3);
  sheet.triangles << 0, 1, 2, 0, 2, 3;
  const Samples samples = sample_shape(sheet, SampleSite::faces);
  const OffsetAnswers up = answer_by_grid(sheet, samples.points, samples.normals, {});
  const OffsetAnswers down = answer_by_grid(sheet, samples.points, -samples.normals, {});
  EXPECT_TRUE(up.directions.isApprox(samples.normals));
  EXPECT_TRUE(down.directions.isApprox(-samples.normals));
  EXPECT_LT(up.values.maxCoeff(), 2e-3 * 0.05);
}

TEST(OffsetSolver, SaysWhatIsNotOnTheSurface) {
  const Shape sphere = test::of_diagonal_1(test::sphere(1, 2));
  Points points(4, 3);
  points << 0, 0, 0, 9, 9, 9, std::nan(""), 0, 0, sphere.vertices.row(0);
  Points normals = Points::Zero(4, 3);
  const OffsetAnswers answers = answer_by_grid(sphere, points, normals, {});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(answers.outcomes[i], OffsetOutcome::missing) << i;
    EXPECT_TRUE(std::isnan(answers.values[static_cast<Eigen::Index>(i)])) << i;
  }
  EXPECT_EQ(answers.outcomes[3], OffsetOutcome::searched);
  EXPECT_NEAR(answers.values[3], 2 * sphere.vertices.row(0).norm(), 0.02);
}

TEST(OffsetSolver, AnswersSamplesOfTrianglesThatOthersStandFor) {
  // 327,680 triangles, of which less than a tenth are kept for an offset of 10 %.
  const Shape sphere = test::of_diagonal_1(test::sphere(1, 7));
  const Samples samples = sample_surface_of(sphere, 2000);
  const OffsetAnswers answers = answer_by_grid(sphere, samples.points, samples.normals, {.offset = 0.1});
  EXPECT_EQ(answers.values,
            answer_by_grid(sphere, samples.points, samples.normals, {.offset = 0.1}, samples.triangles).values);
  const double diameter = 2 * sphere.vertices.row(0).norm();
  for (std::size_t i = 0; i < answers.outcomes.size(); ++i) {
    ASSERT_EQ(answers.outcomes[i], OffsetOutcome::direct) << i;
    EXPECT_NEAR(answers.values[static_cast<Eigen::Index>(i)], diameter, 0.01 * 0.1) << i;
  }
}

TEST(OffsetSolver, HardlyMindsHowAShapeIsTurned) {
  // Arms that meet: around their joints p + r n is covered.
  const double r = 0.05;
  const Shape arms = test::of_diagonal_1(
      test::joined({test::capsule(0.2, 2, 32, 12),
                    test::transformed(test::capsule(0.2, 1.5, 32, 12), 1, test::rotation(3), {0.1, 0.2, 0.3})}));
  const auto answers_for = [&](const Shape& shape) {
    const Samples samples = sample_shape(shape, SampleSite::faces);
    return answer_by_grid(shape, samples.points, samples.normals, {.offset = r});
  };
  const OffsetAnswers answers = answers_for(arms);
  const OffsetAnswers turned = answers_for(test::transformed(arms, 1, test::rotation(7), {0.1, 0.2, 0.3}));
  EXPECT_GT(std::count(answers.outcomes.begin(), answers.outcomes.end(), OffsetOutcome::searched), 200);
  const auto off = ((answers.values - turned.values).array().abs() > 0.01 * r).count();
  EXPECT_LE(off, answers.values.size() / 50);
}

TEST(OffsetSolver, RaisesAnOffsetThatIsTooSmallForTheGrid) {
  const Shape sphere = test::of_diagonal_1(test::sphere(1, 3));
  const Samples samples = sample_shape(sphere, SampleSite::faces);
  const OffsetAnswers answers = answer_by_grid(sphere, samples.points, samples.normals, {.offset = 1e-5});
  EXPECT_GT(answers.offset, 1e-5);
  EXPECT_LT(answers.offset, 2e-3);
  const double diameter = 2 * sphere.vertices.row(0).norm();
  EXPECT_NEAR(answers.values.minCoeff(), diameter, 0.03 * diameter);
  EXPECT_NEAR(answers.values.maxCoeff(), diameter, 0.03 * diameter);
}

}  // namespace
}  // namespace shapegauge
