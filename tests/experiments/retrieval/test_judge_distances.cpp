// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <algorithm>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <limits>
#include <stdexcept>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/experiments/cache/codec.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

/// Signatures that repeat every seven models.
Signatures signatures_of(Eigen::Index models) {
  Signatures signatures(models, 9);
  for (Eigen::Index i = 0; i < signatures.size(); ++i) {
    const Eigen::Index model = i / 9;
    signatures.data()[i] = 0.01F * static_cast<float>((37 * i + 11 * (model % 7) * (i % 9)) % 101);
  }
  return signatures;
}

std::vector<int> labels_of(Eigen::Index models) {
  std::vector<int> labels;
  for (Eigen::Index i = 0; i < models; ++i) labels.push_back(static_cast<int>(i % 7));
  return labels;
}

void expect_same(const Evaluation& one, const Evaluation& other) {
  EXPECT_EQ(one.per_query, other.per_query);
  EXPECT_EQ(one.per_class, other.per_class);
  EXPECT_EQ(one.micro, other.micro);
  EXPECT_EQ(one.macro, other.macro);
  EXPECT_EQ(one.micro_curve.precision, other.micro_curve.precision);
  EXPECT_EQ(one.queries, other.queries);
  EXPECT_EQ(one.queries_with_ties, other.queries_with_ties);
  EXPECT_EQ(one.first_tier_bounds.pessimistic, other.first_tier_bounds.pessimistic);
  EXPECT_EQ(one.first_tier_bounds.optimistic, other.first_tier_bounds.optimistic);
}

/// Ranges of that many rows each.
std::vector<RowRange> ranges_of(Eigen::Index all, Eigen::Index rows) {
  std::vector<RowRange> ranges;
  for (Eigen::Index first = 0; first < all; first += rows) ranges.push_back({first, std::min(first + rows, all)});
  return ranges;
}

TEST(EvaluationByRows, MatchesTheWholeMatrixForAnyNumberOfRowsPerBlock) {
  const std::vector<EvaluationOptions> options = {{.protocol = Protocol::psb}, {.protocol = Protocol::paper}};
  const NamedDistance distance = distances().at("l1");
  for (const Eigen::Index models : {2, 3, 40, 700}) {
    const Signatures signatures = signatures_of(models);
    std::vector<int> labels = labels_of(models);
    if (models <= 3) labels.assign(labels.size(), 0);
    const DistanceMatrix whole = distance_matrix(signatures, "l1");
    const RetrievalTask task = leave_one_out(labels);
    for (const Eigen::Index rows : {Eigen::Index{1}, Eigen::Index{13}, models}) {
      SCOPED_TRACE(fmt::format("{} rows of {}", rows, models));
      std::vector<RowScores> scores;
      double seconds = 0;
      DistanceMatrix seen = DistanceMatrix::Zero(models, models);
      for (const RowRange& range : ranges_of(models, rows)) {
        const auto visit = [&](const RowVisitor& judge) {
          visit_distances(distance, signatures, range, [&](Eigen::Index first, const DistanceTable& some) {
            seen.middleRows(first, some.rows()) = some;
            judge(first, some);
          });
        };
        scores.push_back(decode<RowScores>(encode(evaluate_row_range(task, options, range, visit, seconds))));
      }
      EXPECT_EQ(seen, whole);
      const std::vector<Evaluation> evaluations = evaluations_of(task, options, scores);
      ASSERT_EQ(evaluations.size(), 2U);
      for (std::size_t i = 0; i < 2; ++i) expect_same(evaluations[i], evaluate(whole, labels, options[i]));
    }
  }
}

TEST(LargestDistance, FromTheFirstModelIsFoundWhereverTheFarthestModelIs) {
  for (const Eigen::Index far : {1, 3, 5}) {
    Signatures signatures = Signatures::Constant(6, 1, 1);
    signatures(0, 0) = 0;
    signatures(far, 0) = 8;
    EXPECT_EQ(largest_distance_from_first(distances().at("l1"), signatures), 8) << far;
  }
}

TEST(VisitDistances, RejectsASignatureWithNonFiniteValues) {
  Signatures signatures = signatures_of(10);
  signatures(8, 3) = std::numeric_limits<float>::infinity();
  EXPECT_THAT(test::input_error_of([&] {
                visit_distances(distances().at("l1"), signatures, {0, 10}, [](Eigen::Index, const DistanceTable&) {});
              }),
              testing::HasSubstr("signature 8"));
}

TEST(MatrixFile, ContainsTheAddedRowsInOrder) {
  const test::TemporaryFolder folder;
  const DistanceMatrix whole = distance_matrix(signatures_of(20), "l1");
  MatrixFile file(folder.path() / "matrix.npy", 20);
  file.add(whole.topRows(7));
  file.add(whole.bottomRows(13));
  file.close();
  EXPECT_EQ(read_matrix(folder.path() / "matrix.npy", TableShape::square).numbers, whole);
}

TEST(MatrixFile, ReportsAFullDisk) {
  MatrixFile file("/dev/full", 400);
  EXPECT_THROW(
      {
        file.add(DistanceMatrix::Zero(400, 400));
        file.close();
      },
      std::runtime_error);
}

}  // namespace

}  // namespace shapegauge
