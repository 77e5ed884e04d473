#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "shapegauge/metrics/distance_table.h"

namespace shapegauge {

/// What is odd about a matrix of distances. None of it keeps figures from being computed; each may mean that the matrix
/// is not what it is taken for.
struct MatrixFindings {
  Eigen::Index infinite = 0;          ///< entries off the diagonal
  Eigen::Index negative = 0;          ///< entries off the diagonal
  Eigen::Index asymmetric_pairs = 0;  ///< entries (i, j) and (j, i) that are not equal; i < j
  double largest_asymmetry = 0;       ///< |(i, j) - (j, i)|, infinite ones left out
  Eigen::Index nonzero_diagonal = 0;
  /// Rows in which the diagonal holds the largest entry and not the smallest as well: in a matrix of distances none.
  Eigen::Index rows_nearest_to_others = 0;
  std::vector<std::pair<Eigen::Index, Eigen::Index>>
      equal_rows;                           ///< each row that repeats an earlier one, and that one
  std::vector<Eigen::Index> constant_rows;  ///< all entries off the diagonal are equal
};

/// Looks at every entry. `square`: row i and column i are the same model, so that there is a diagonal. Parallel over
/// rows, the same answer for any number of threads.
MatrixFindings check_matrix(const DistanceTable& distances, bool square);

}  // namespace shapegauge
