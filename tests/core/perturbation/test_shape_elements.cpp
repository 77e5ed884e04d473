#include <algorithm>
#include <gtest/gtest.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/shape_elements.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

TEST(RandomSelection, HasExactlyTheRoundedNumber) {
  RandomNumbers random(1);
  for (const auto& [count, fraction, expected] : {std::tuple{10, 0.0, 0},
                                                  {10, 1.0, 10},
                                                  {10, 0.24, 2},
                                                  {10, 0.26, 3},
                                                  {7, 0.5, 4},
                                                  {1001, 0.15, 150},
                                                  {0, 0.5, 0}}) {
    EXPECT_EQ(std::ranges::count(random_selection(count, fraction, random), true), expected)
        << count << " " << fraction;
  }
}

TEST(RandomSelection, TakesEveryElementEquallyOften) {
  RandomNumbers random(2);
  std::vector<int> times(8);
  for (int i = 0; i < 40000; ++i) {
    const std::vector<bool> selected = random_selection(8, 0.375, random);
    for (std::size_t k = 0; k < 8; ++k) times[k] += selected[k] ? 1 : 0;
  }
  // 40000 times 3/8, standard deviation 97; five of them.
  for (const int t : times) EXPECT_NEAR(t, 15000, 485);
}

TEST(RandomSelection, RefusesWhatIsNoFraction) {
  RandomNumbers random(1);
  for (const double fraction : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(random_selection(10, fraction, random), InputError);
  }
}

TEST(WithoutElements, KeepsOrderAndVerticesOfAMesh) {
  const Shape box = test_shapes::box({1, 1, 1}, 1);
  std::vector<bool> removed(12);
  removed[0] = removed[5] = true;
  const Shape rest = without_elements(box, removed);
  ASSERT_EQ(rest.triangles.rows(), 10);
  EXPECT_EQ(rest.triangles.topRows(4), box.triangles.middleRows(1, 4));
  EXPECT_EQ(rest.triangles.bottomRows(6), box.triangles.bottomRows(6));
  EXPECT_EQ(rest.vertices, box.vertices);
}

TEST(WithoutElements, TakesNormalsAwayWithThePoints) {
  Shape cloud;
  cloud.vertices = Points::Random(3, 3);
  cloud.normals = Points::Random(3, 3);
  const Shape rest = without_elements(cloud, {false, true, false});
  ASSERT_EQ(rest.vertices.rows(), 2);
  EXPECT_EQ(rest.vertices.row(1), cloud.vertices.row(2));
  EXPECT_EQ(rest.normals.row(1), cloud.normals.row(2));
}

TEST(WithoutElements, LeavesSomething) {
  EXPECT_THROW(without_elements(test_shapes::box({1, 1, 1}, 1), std::vector<bool>(12, true)), InputError);
  EXPECT_THROW(without_elements(Shape{}, {}), InputError);
}

}  // namespace
}  // namespace shapegauge
