// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/segmentation_errors.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;
using Weights = std::vector<double>;

/// Different orders of summation over 60 elements: a few hundred roundings of numbers up to 1.
constexpr double of_sums = 1e-12;

/// Direct evaluation of the definitions over pairs and sets of elements. Shares no code with the
/// library.
struct Naive {
  const Labels& labels;
  const Labels& truth;
  const Weights& weights;

  double total() const {
    double sum = 0;
    for (const double w : weights) sum += w;
    return sum;
  }

  double rand_index() const {
    double disagreeing = 0;
    double pairs = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t j = i + 1; j < labels.size(); ++j) {
        pairs += weights[i] * weights[j];
        if ((labels[i] == labels[j]) != (truth[i] == truth[j])) disagreeing += weights[i] * weights[j];
      }
    }
    return pairs > 0 ? disagreeing / pairs : 0;
  }

  double common(const Labels& a, std::int32_t x, const Labels& b, std::int32_t y) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] == x && b[i] == y ? weights[i] : 0;
    return sum;
  }

  double whole(const Labels& a, std::int32_t x) const { return common(a, x, a, x); }

  /// Sum over the segments of `a` of the elements outside the largest overlap with a segment of `b`.
  double outside(const Labels& a, const Labels& b) const {
    double sum = 0;
    for (const std::int32_t x : std::set(a.begin(), a.end())) {
      double largest = 0;
      for (const std::int32_t y : std::set(b.begin(), b.end())) largest = std::max(largest, common(a, x, b, y));
      sum += whole(a, x) - largest;
    }
    return sum / total();
  }

  double refinement(const Labels& a, const Labels& b, std::size_t i) const {
    const double segment = whole(a, a[i]);
    return segment > 0 ? (segment - common(a, a[i], b, b[i])) / segment : 0;
  }

  double global_consistency() const {
    double one = 0;
    double other = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      one += weights[i] * refinement(labels, truth, i);
      other += weights[i] * refinement(truth, labels, i);
    }
    return std::min(one, other) / total();
  }

  double local_consistency() const {
    double sum = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      sum += weights[i] * std::min(refinement(labels, truth, i), refinement(truth, labels, i));
    }
    return sum / total();
  }
};

void expect_as_naive(const Labels& labels, const Labels& truth, const Weights& weights,
                     const SegmentationErrors& errors) {
  const Naive naive{labels, truth, weights};
  EXPECT_NEAR(errors.rand_index, naive.rand_index(), of_sums);
  EXPECT_NEAR(errors.missing_rate, naive.outside(truth, labels), of_sums);
  EXPECT_NEAR(errors.false_alarm_rate, naive.outside(labels, truth), of_sums);
  EXPECT_NEAR(errors.hamming, (naive.outside(truth, labels) + naive.outside(labels, truth)) / 2, of_sums);
  EXPECT_NEAR(errors.global_consistency, naive.global_consistency(), of_sums);
  EXPECT_NEAR(errors.local_consistency, naive.local_consistency(), of_sums);
}

Labels arbitrary_labels(std::size_t count) {
  const auto most = *rc::gen::inRange<std::int32_t>(1, 8);
  return *rc::gen::container<Labels>(count, rc::gen::inRange<std::int32_t>(-2, most));
}

RC_GTEST_PROP(SegmentationErrors, MatchANaiveImplementationOnRandomLabels, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 60);
  const Labels labels = arbitrary_labels(count);
  const Labels truth = arbitrary_labels(count);
  expect_as_naive(labels, truth, Weights(count, 1), segmentation_errors(labels, truth));
  Weights weights;
  for (std::size_t i = 0; i < count; ++i) weights.push_back(*rc::gen::inRange(0, 20) / 8.0);
  weights[0] = 1;
  expect_as_naive(labels, truth, weights, segmentation_errors(labels, truth, weights));
}

RC_GTEST_PROP(SegmentationErrors, DoNotDependOnLabelsOfSegmentsOrOrderOfElements, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(2, 60);
  Labels labels = arbitrary_labels(count);
  Labels truth = arbitrary_labels(count);
  const SegmentationErrors before = segmentation_errors(labels, truth);
  for (std::int32_t& label : labels) label = 1000 - 7 * label;
  std::ranges::reverse(labels);
  std::ranges::reverse(truth);
  const SegmentationErrors after = segmentation_errors(labels, truth);
  RC_ASSERT(after.rand_index == before.rand_index);
  RC_ASSERT(std::abs(after.hamming - before.hamming) < of_sums);
  RC_ASSERT(std::abs(after.global_consistency - before.global_consistency) < of_sums);
  RC_ASSERT(std::abs(after.local_consistency - before.local_consistency) < of_sums);
}

TEST(SegmentationErrors, AreZeroForIdenticalPartitions) {
  const SegmentationErrors errors = segmentation_errors(Labels{4, 4, -1, 7, 7}, Labels{0, 0, 1, 2, 2});
  EXPECT_EQ(errors.rand_index, 0);
  EXPECT_EQ(errors.hamming, 0);
  EXPECT_EQ(errors.global_consistency, 0);
  EXPECT_EQ(errors.local_consistency, 0);
}

TEST(SegmentationErrors, MatchAnExampleOfSixElements) {
  // Found {0 1 2 3} {4 5}, true {0 1} {2 3 4 5}.
  const SegmentationErrors errors = segmentation_errors(Labels{0, 0, 0, 0, 1, 1}, Labels{0, 0, 1, 1, 1, 1});
  EXPECT_NEAR(errors.rand_index, 8.0 / 15, of_sums);  // {0 1} x {2 3} and {2 3} x {4 5} of 15 pairs
  EXPECT_NEAR(errors.missing_rate, 2.0 / 6, of_sums);
  EXPECT_NEAR(errors.false_alarm_rate, 2.0 / 6, of_sums);
  EXPECT_NEAR(errors.global_consistency, 2.0 / 6, of_sums);  // 4 elements, half of their segment outside, over 6
  EXPECT_NEAR(errors.local_consistency, 1.0 / 6, of_sums);   // only 2 and 3 lie in halves both ways
}

TEST(SegmentationErrors, ConsistencyErrorsAreZeroForARefinement) {
  const SegmentationErrors errors = segmentation_errors(Labels{0, 1, 2, 3}, Labels{0, 0, 1, 1});
  EXPECT_NEAR(errors.missing_rate, 0.5, of_sums);
  EXPECT_EQ(errors.false_alarm_rate, 0);
  EXPECT_EQ(errors.global_consistency, 0);
  EXPECT_EQ(errors.local_consistency, 0);
}

TEST(SegmentationErrors, AreZeroForOneElement) { EXPECT_EQ(segmentation_errors(Labels{3}, Labels{5}).rand_index, 0); }

TEST(SegmentationErrors, RejectLabelsAndWeightsOfDifferentSizesAndNonPositiveWeights) {
  EXPECT_THROW(segmentation_errors(Labels{}, Labels{}), ArgumentError);
  EXPECT_THROW(segmentation_errors(Labels{1, 2}, Labels{1}), ArgumentError);
  EXPECT_THROW(segmentation_errors(Labels{1}, Labels{1}, Weights{1, 1}), ArgumentError);
  EXPECT_THROW(segmentation_errors(Labels{1}, Labels{1}, Weights{-1}), ArgumentError);
  EXPECT_THROW(segmentation_errors(Labels{1}, Labels{1}, Weights{0}), ArgumentError);
  EXPECT_THROW(segmentation_errors(Labels{1}, Labels{1}, Weights{std::nan("")}), ArgumentError);
}

TEST(SegmentationErrors, HaveUniqueNames) {
  std::set<std::string_view> names;
  for (const SegmentationErrorEntry& entry : segmentation_error_entries()) names.insert(entry.name);
  EXPECT_EQ(names.size(), segmentation_error_entries().size());
}

/// A strip of squares: vertices 2i and 2i + 1 are the ends of the i-th rung, triangle i lies between rungs i and i + 1
/// (treated as a triangle).
std::vector<MeshEdge> ladder(std::int32_t squares) {
  std::vector<MeshEdge> edges;
  for (std::int32_t i = 0; i <= squares; ++i) {
    const bool inside = i > 0 && i < squares;
    const std::int32_t before = i > 0 ? i - 1 : 0;
    edges.push_back({.vertices = {2 * i, 2 * i + 1}, .triangles = {before, inside ? i : -1}, .length = 1});
    if (i == squares) break;
    edges.push_back({.vertices = {2 * i, 2 * i + 2}, .triangles = {i, -1}, .length = 1});
    edges.push_back({.vertices = {2 * i + 1, 2 * i + 3}, .triangles = {i, -1}, .length = 1});
  }
  return edges;
}

TEST(CutDiscrepancy, IsTwiceTheDistanceBetweenTwoParallelCuts) {
  const std::vector<MeshEdge> edges = ladder(6);
  EXPECT_NEAR(cut_discrepancy(Labels{0, 1, 1, 1, 1, 1}, Labels{0, 0, 0, 0, 1, 1}, edges, 14, 2.0), 2 * 3 / 2.0,
              of_sums);
}

TEST(CutDiscrepancy, WeighsCutsByLengthAndIsSymmetric) {
  const std::vector<MeshEdge> edges = ladder(6);
  const Labels two_cuts = {0, 1, 1, 1, 1, 2};  // after squares 0 and 4
  const Labels one_cut = {0, 0, 1, 1, 1, 1};   // after square 1
  // From two cuts: ways 1 and 3, mean 2. From the one cut to the nearer: 1.
  EXPECT_NEAR(cut_discrepancy(two_cuts, one_cut, edges, 14, 1.0), 3, of_sums);
  EXPECT_NEAR(cut_discrepancy(one_cut, two_cuts, edges, 14, 1.0), 3, of_sums);
}

TEST(CutDiscrepancy, UsesPathLengthsAlongEdgesAndCutLengths) {
  // Rungs of lengths 1 to 5, 0.5, 1, 1.5 and 2 apart.
  std::vector<MeshEdge> edges = ladder(4);
  for (MeshEdge& edge : edges) {
    const auto [a, b] = edge.vertices;
    edge.length = b == a + 1 ? 1 + a / 2 : 0.5 * (1 + a / 2);
  }
  const Labels two_cuts = {0, 1, 1, 2};  // rungs 1 and 3, of lengths 2 and 4
  const Labels one_cut = {0, 0, 1, 1};   // rung 2
  // From two cuts: ways 1 and 1.5. From the one cut to the nearer: 1.
  EXPECT_NEAR(cut_discrepancy(two_cuts, one_cut, edges, 10, 1.0), (2 * 1 + 4 * 1.5) / 6 + 1, of_sums);
}

TEST(CutDiscrepancy, IgnoresSeparatePartsWithoutCuts) {
  std::vector<MeshEdge> edges = ladder(3);
  edges.push_back({.vertices = {8, 9}, .triangles = {3, -1}, .length = 1});
  EXPECT_NEAR(cut_discrepancy(Labels{0, 1, 1, 1}, Labels{0, 0, 1, 1}, edges, 10, 1.0), 2, of_sums);
}

TEST(CutDiscrepancy, IsUndefinedIfOneSegmentationHasNoCuts) {
  const std::vector<MeshEdge> edges = ladder(3);
  EXPECT_EQ(cut_discrepancy(Labels{0, 0, 0}, Labels{5, 5, 5}, edges, 8, 1.0), 0);
  EXPECT_TRUE(std::isnan(cut_discrepancy(Labels{0, 0, 1}, Labels{5, 5, 5}, edges, 8, 1.0)));
  EXPECT_TRUE(std::isnan(cut_discrepancy(Labels{5, 5, 5}, Labels{0, 0, 1}, edges, 8, 1.0)));
}

TEST(CutDiscrepancy, RejectsEdgesWithInvalidIndices) {
  const Labels labels = {0, 1, 1};
  std::vector<MeshEdge> edges = ladder(3);
  EXPECT_THROW(cut_discrepancy(labels, labels, edges, 7, 1.0), ArgumentError);
  EXPECT_THROW(cut_discrepancy(labels, labels, edges, 8, 0.0), ArgumentError);
  edges[0].triangles = {3, -1};
  EXPECT_THROW(cut_discrepancy(labels, labels, edges, 8, 1.0), ArgumentError);
  edges[0].triangles = {0, -1};
  edges[0].length = std::nan("");
  EXPECT_THROW(cut_discrepancy(labels, labels, edges, 8, 1.0), ArgumentError);
}

}  // namespace
}  // namespace shapegauge
