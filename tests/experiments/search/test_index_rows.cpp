// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/experiments/search/index_rows.h"
#include "tests/experiments/search/searched_folder.h"

namespace shapegauge {
namespace {

using test::SearchedFolder;

/// The distances between all models by each term, one pair at a time.
std::vector<DistanceMatrix> pairwise_distances(const OpenIndex& index) {
  std::vector<DistanceMatrix> matrices;
  const std::vector<NamedDistance> named = distances_of(index.method);
  for (std::size_t k = 0; k < named.size(); ++k) {
    const auto table = index.contents.tables[k].signatures();
    DistanceMatrix& matrix = matrices.emplace_back(table.rows(), table.rows());
    const auto signature = [&](Eigen::Index i) {
      return std::span(table.data() + i * table.cols(), static_cast<std::size_t>(table.cols()));
    };
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        matrix(i, j) = i == j ? 0 : named[k].function(signature(i), signature(j));
      }
    }
  }
  return matrices;
}

/// The sum over the models, computed from whole matrices.
DistanceMatrix whole_sum(const OpenIndex& index) {
  const std::vector<DistanceMatrix> matrices = pairwise_distances(index);
  const auto& [weights, options] = index.method.sum;
  return sum_of_distances(matrices, sum_weights(matrices, weights, options.weights), options.scale);
}

std::vector<Eigen::RowVectorXf> rows_of_tables(const ShapeIndex& index, Eigen::Index row) {
  std::vector<Eigen::RowVectorXf> rows;
  for (const IndexTable& table : index.tables) rows.emplace_back(table.signatures().row(row));
  return rows;
}

void expect_sum_of(const CollectionSum& sum, const OpenIndex& index, const DistanceMatrix& expected) {
  const std::vector<NamedDistance> named = distances_of(index.method);
  for (Eigen::Index i = 0; i < expected.rows(); ++i) {
    const std::vector<Eigen::VectorXd> terms =
        term_distances(named, index.contents, rows_of_tables(index.contents, i), i);
    EXPECT_EQ(sum_row(sum, terms, i), expected.row(i).transpose()) << i;
  }
}

TEST(IndexRows, ContainThePairwiseDistancesOfEachSummedSignature) {
  const SearchedFolder folder;
  for (const char* signature : {"local", "median", "bag"}) {
    const OpenIndex index = folder.open(signature);
    const std::vector<DistanceMatrix> expected = pairwise_distances(index);
    const std::vector<NamedDistance> named = distances_of(index.method);
    ASSERT_EQ(named.size(), index.method.terms.size());
    for (Eigen::Index i = 0; i < 9; ++i) {
      const std::vector<Eigen::RowVectorXf> rows = rows_of_tables(index.contents, i);
      const std::vector<Eigen::VectorXd> of_member = term_distances(named, index.contents, rows, i);
      const std::vector<Eigen::VectorXd> of_copy = term_distances(named, index.contents, rows, -1);
      for (std::size_t k = 0; k < named.size(); ++k) {
        EXPECT_EQ(of_member[k], expected[k].row(i).transpose()) << signature << ' ' << i;
        EXPECT_EQ(of_copy[k], expected[k].row(i).transpose()) << signature << ' ' << i;
      }
    }
  }
}

TEST(IndexRows, SumByRowEqualsTheSumOfWholeDistanceMatrices) {
  const SearchedFolder folder;
  for (const char* signature : {"local", "median", "mutual ranks", "d2"}) {
    SCOPED_TRACE(signature);
    const OpenIndex index = folder.open(signature);
    expect_sum_of(sum_of(index.method, index.contents, {}), index, whole_sum(index));
  }
}

TEST(IndexRows, YieldTheNearestModelsOfTheWholeDistanceMatrix) {
  const SearchedFolder folder;
  for (const char* signature : {"local", "d2"}) {
    const OpenIndex index = folder.open(signature);
    const DistanceMatrix sums = whole_sum(index);
    for (const int count : {1, 3, 8}) {
      const NearestModels found = nearest_models_in_index(index.method, index.contents, count, {});
      const NearestModels expected = nearest_models(9, count, rows_of(sums));
      EXPECT_EQ(found.indices, expected.indices) << signature << ' ' << count;
      EXPECT_EQ(found.distances, expected.distances);
      EXPECT_EQ(found.largest, expected.largest);
    }
  }
}

TEST(IndexRows, StopWhenInterrupted) {
  const SearchedFolder folder;
  const OpenIndex index = folder.open();
  const RunControl interrupted{.interrupted = [] { return true; }};
  EXPECT_THROW(sum_of(index.method, index.contents, interrupted), Interrupted);
  EXPECT_THROW(nearest_models_in_index(index.method, index.contents, 2, interrupted), Interrupted);
}

}  // namespace
}  // namespace shapegauge
