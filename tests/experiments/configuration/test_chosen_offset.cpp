// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// A box of 4 x 4 x 2 with a square hole of 1 in its top.
Shape box_with_hole() {
  Shape box = test::box({4, 4, 2}, 8);
  std::vector<Eigen::Index> remaining;
  for (Eigen::Index f = 0; f < box.triangles.rows(); ++f) {
    double width = 0;
    double lowest = 1;
    for (const std::int32_t corner : box.triangles.row(f)) {
      width = std::max(width, box.vertices.row(corner).head<2>().cwiseAbs().maxCoeff());
      lowest = std::min(lowest, box.vertices(corner, 2));
    }
    if (lowest < 0.9 || width > 0.6) remaining.push_back(f);
  }
  box.triangles = box.triangles(remaining, Eigen::all).eval();
  return box;
}

const double gap = 0.5 / 6;  // of the diagonal

TEST(ChooseOffset, KeepsARequestedOffset) {
  const ChosenOffset chosen = choose_offset(0.05, box_with_hole());
  EXPECT_EQ(chosen.offset, 0.05);
  EXPECT_NEAR(chosen.gap, gap, 0.005);
  EXPECT_FALSE(chosen.automatic);
  EXPECT_EQ(choose_offset(0.05, test::box({4, 3, 1}, 1)).gap, 0);
}

TEST(ChooseOffset, ComputesAnAutomaticOffsetIfNoneIsRequested) {
  const Shape box = test::box({4, 3, 1}, 2);
  const ChosenOffset chosen = choose_offset({}, box);
  ASSERT_TRUE(chosen.automatic);
  EXPECT_EQ(chosen.offset, automatic_offset(box).offset);
}

TEST(ReasonsForOffset, StateWhetherTheOffsetClosesGapsAndSmoothsNoise) {
  const auto reasons = [](const AutomaticOffset& automatic) {
    return reasons_for_offset(chosen_automatically(automatic));
  };
  EXPECT_EQ(reasons({.offset = 0.01}), "no gaps or noise found");
  EXPECT_EQ(reasons({.offset = 0.02, .gap = 0.02, .widest_gap = 0.018, .noise = 0.01}),
            "2 % closes the gaps, 1 % smooths the noise");
  EXPECT_EQ(reasons({.offset = 0.02, .gap = 0.02, .widest_gap = 0.1}), "2 % closes the narrower gaps");
  EXPECT_EQ(reasons({.offset = 0.05, .gap = 0.9, .widest_gap = 0.8, .noise = 0.02, .sufficient = false}),
            "closing the gaps would take 90 %, 2 % smooths the noise");
  EXPECT_EQ(reasons({.offset = 0.01, .widest_gap = 0.1}), "no noise, and gaps too wide to close");
  EXPECT_EQ(reasons_for_offset({.offset = 0.1, .automatic = {}}), "");
}

TEST(ChooseOffset, RejectsAShapeWhoseVerticesCoincide) {
  EXPECT_THROW(choose_offset({}, Shape{Points::Zero(3, 3), Triangles{{0, 1, 2}}}), InputError);
}

TEST(LeakWarning, AppearsOnlyIfTheOffsetDoesNotCloseTheGap) {
  EXPECT_TRUE(leak_warning(choose_offset(0.8 * gap, box_with_hole())));
  EXPECT_FALSE(leak_warning(choose_offset(1.2 * gap, box_with_hole())));
  EXPECT_FALSE(leak_warning(choose_offset(0.001, test::box({4, 3, 1}, 1))));
}

TEST(LeakWarning, SuggestsAnOffsetThatClosesTheGap) {
  // 1.1 times the gap, 0.0917, rounded up to two digits.
  EXPECT_NE(leak_warning({.offset = 0.01, .gap = gap, .automatic = {}})->find("0.092"), std::string::npos);
  for (const double wide : {0.2, 0.84, 1.0}) {
    EXPECT_EQ(leak_warning({.offset = 0.05, .gap = wide, .automatic = {}})->find("`offset"), std::string::npos) << wide;
  }
}

}  // namespace
}  // namespace shapegauge
