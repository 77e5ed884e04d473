#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// A box of 4 x 3 x 1 without its lid. The largest circle in the hole has a radius of 1.5.
Shape open_box() {
  Shape box = test::box({4, 3, 1}, 1);
  Triangles kept(0, 3);
  for (const auto& triangle : box.triangles.rowwise()) {
    bool is_lid = true;
    for (const std::int32_t corner : triangle) is_lid = is_lid && box.vertices(corner, 2) > 0;
    if (is_lid) continue;
    kept.conservativeResize(kept.rows() + 1, Eigen::NoChange);
    kept.bottomRows<1>() = triangle;
  }
  box.triangles = kept;
  return box;
}

const double gap = 1.5 / std::sqrt(26.0);  // of the diagonal

TEST(ChooseOffset, AGivenOneStaysBesideTheGap) {
  const ChosenOffset chosen = choose_offset(0.05, open_box());
  EXPECT_EQ(chosen.offset, 0.05);
  EXPECT_NEAR(chosen.gap, gap, 0.02 * gap);
  EXPECT_FALSE(chosen.automatic);
  EXPECT_EQ(choose_offset(0.05, test::box({4, 3, 1}, 1)).gap, 0);
}

TEST(ChooseOffset, WithoutOneItIsTheAutomaticOffset) {
  const Shape box = test::box({4, 3, 1}, 2);
  const ChosenOffset chosen = choose_offset({}, box);
  ASSERT_TRUE(chosen.automatic);
  EXPECT_EQ(chosen.offset, automatic_offset(box).offset);
  EXPECT_FALSE(leaves_gaps_open(chosen));
  EXPECT_TRUE(leaves_gaps_open(choose_offset({}, open_box()))) << "the lid is no gap";
}

TEST(ChooseOffset, RefusesAShapeWithoutExtent) {
  EXPECT_THROW(choose_offset({}, Shape{Points::Zero(3, 3), Triangles{{0, 1, 2}}}), InputError);
}

TEST(LeakWarning, IsOfOffsetsBelowTheGap) {
  EXPECT_TRUE(leak_warning(choose_offset(0.9 * gap, open_box())));
  EXPECT_FALSE(leak_warning(choose_offset(1.1 * gap, open_box())));
  EXPECT_FALSE(leak_warning(choose_offset(0.001, test::box({4, 3, 1}, 1))));
}

TEST(LeakWarning, NamesAnOffsetThatIsEnough) {
  // 1.1 times the gap, 0.3236, rounded up to two digits.
  EXPECT_NE(leak_warning({.offset = 0.01, .gap = gap, .automatic = {}})->find("0.33"), std::string::npos);
}

TEST(TwoSidedWarning, CountsSamplesBelowHalfTheOffsetUnlessTheShapeIsClosed) {
  const double offset = 0.1 * std::sqrt(26.0);
  const Eigen::VectorXd values{{0.4 * offset, 0.6 * offset, 0.3 * offset}};
  const auto warning = two_sided_warning(open_box(), values, 0.1);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->find("2 of 3 "), 0U) << *warning;
  EXPECT_FALSE(two_sided_warning(test::box({4, 3, 1}, 1), values, 0.1));
  EXPECT_FALSE(two_sided_warning(open_box(), values, 0.05)) << "none is below half of it";
}

}  // namespace
}  // namespace shapegauge
