// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/paper_segmentation.h"
#include "shapegauge/segmentation/segment_shape.h"
#include "tests/segmentation/dumbbell.h"

namespace shapegauge {

namespace {

TEST(SegmentShape, RunsTheRequestedAlgorithmWithItsOptions) {
  const Shape shape = test::dumbbell(3);
  const PartSegmentationOptions best{.parts = 4, .patches = 60};
  EXPECT_EQ(segment_shape(shape, {.best = best}), part_segmentation(shape, best));
  const SegmentationOptions paper{.method = SegmentationAlgorithm::paper};
  EXPECT_EQ(segment_shape(shape, paper), paper_segmentation(shape, paper.offset));
  SegmentationOptions two = paper;
  two.best.parts = 2;
  two.field = SegmentedSdf::cone;
  PaperSegmentationOptions two_clusters;
  two_clusters.clusters = 2;
  EXPECT_EQ(segment_shape(shape, two), paper_segmentation(shape, std::nullopt, two_clusters));
}

TEST(SegmentShape, RefusesOptionsOutOfRange) {
  const Shape shape = test::dumbbell(1);
  EXPECT_THROW(segment_shape(shape, {.best = {.min_probability = 1.5}}), InputError);
  EXPECT_THROW(segment_shape(shape, {.method = SegmentationAlgorithm::paper, .offset = 2}), InputError);
}

TEST(SegmentationParameters, StateTheAlgorithmTheyBelongTo) {
  for (const char* of_best : {"patches", "min_probability", "border_width"}) {
    EXPECT_EQ(algorithm_with(of_best), SegmentationAlgorithm::best) << of_best;
  }
  for (const char* of_paper : {"field", "offset"}) {
    EXPECT_EQ(algorithm_with(of_paper), SegmentationAlgorithm::paper) << of_paper;
  }
  for (const char* of_both : {"method", "parts"}) EXPECT_EQ(algorithm_with(of_both), std::nullopt) << of_both;
}

}  // namespace

}  // namespace shapegauge
