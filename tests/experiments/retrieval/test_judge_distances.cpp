#include <Eigen/Core>
#include <gtest/gtest.h>
#include <limits>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"
#include "tests/support/test_files.h"
#include "tests/support/thread_ranks.h"

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

Signatures part_of(const Signatures& signatures, const Communicator& ranks) {
  const RankRange own = part_of_rank(static_cast<std::size_t>(signatures.rows()), ranks.rank(), ranks.size());
  return signatures.middleRows(static_cast<Eigen::Index>(own.first), static_cast<Eigen::Index>(own.size()));
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

class JudgedDistances : public testing::TestWithParam<int> {};

TEST_P(JudgedDistances, AreThoseOfTheWholeMatrixOnAnyNumberOfRanks) {
  const test::TemporaryFolder folder;
  for (const Eigen::Index models : {2, 3, 40, 1500}) {  // two ranks or more have no row of two models; blocks of two
    SCOPED_TRACE(models);
    const Signatures signatures = signatures_of(models);
    std::vector<int> labels = labels_of(models);
    if (models <= 3) labels.assign(labels.size(), 0);
    const DistanceMatrix whole = distance_matrix(signatures, "l1");
    const std::vector<EvaluationOptions> options = {{.protocol = Protocol::psb}, {.protocol = Protocol::paper}};
    const std::filesystem::path file = folder.path() / "matrix.npy";
    Judgement found;
    test::on_thread_ranks(GetParam(), [&](Communicator& ranks) {
      const NamedDistance distance = distances().at("l1");
      const Signatures rows = part_of(signatures, ranks);
      const auto all = static_cast<std::size_t>(models);
      const SharedSignatures shared{.rows = rows, .all = all};
      DistanceJudge judge(labels, part_of_rank(all, ranks.rank(), ranks.size()),
                          {.evaluations = options,
                           .overview = true,
                           .largest = largest_of_first(distance, shared, ranks),
                           .file = file},
                          ranks);
      visit_distances(distance, shared, ranks,
                      [&](Eigen::Index first, const DistanceTable& some) { judge.add(first, some); });
      Judgement judgement = judge.finish();
      if (ranks.rank() == 0) found = std::move(judgement);
    });
    ASSERT_EQ(found.evaluations.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) expect_same(found.evaluations[i], evaluate(whole, labels, options[i]));
    const DistanceOverview overview = overview_of(whole, labels);
    EXPECT_EQ(found.overview->block, overview.block);
    EXPECT_EQ(found.overview->cells, overview.cells);
    EXPECT_EQ(found.overview->nearest, overview.nearest);
    EXPECT_EQ(found.overview->nearest_distances, overview.nearest_distances);
    EXPECT_EQ(read_matrix(file, TableShape::square).numbers, whole);
  }
}

INSTANTIATE_TEST_SUITE_P(Ranks, JudgedDistances, testing::Values(1, 2, 3, 4));

TEST(LargestOfFirst, IsThatOfAllRanksWhicheverHasIt) {
  for (const Eigen::Index far : {1, 3, 5}) {
    Signatures signatures = Signatures::Constant(6, 1, 1);
    signatures(0, 0) = 0;
    signatures(far, 0) = 8;
    test::on_thread_ranks(3, [&](Communicator& ranks) {
      const SharedSignatures shared{.rows = part_of(signatures, ranks), .all = 6};
      EXPECT_EQ(largest_of_first(distances().at("l1"), shared, ranks), 8) << far;
    });
  }
}

TEST(VisitDistances, ASignatureWithoutADistanceIsAnErrorOfAllRanks) {
  Signatures signatures = signatures_of(10);
  signatures(8, 3) = std::numeric_limits<float>::infinity();
  int errors = 0;
  std::mutex mutex;
  test::on_thread_ranks(3, [&](Communicator& ranks) {
    try {
      visit_distances(distances().at("l1"), {.rows = part_of(signatures, ranks), .all = 10}, ranks,
                      [](Eigen::Index, const DistanceTable&) {});
    } catch (const SharedError& error) {
      EXPECT_NE(std::string(error.what()).find("signature 8"), std::string::npos);
      const std::scoped_lock lock(mutex);
      ++errors;
    }
  });
  EXPECT_EQ(errors, 3);
}

}  // namespace

}  // namespace shapegauge
