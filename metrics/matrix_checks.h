#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

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

/// What is odd about the rows of a matrix, which come some after the others, as where it is never there as a whole.
class MatrixChecks {
 public:
  /// `square`: row i and column i are the same model, so that there is a diagonal.
  explicit MatrixChecks(bool square) : square_(square) {}

  /// Looks at every entry of rows that follow those before. In parallel, the same answer for any number of threads.
  void add(const DistanceTable& rows);

  /// Of all rows so far, but for the asymmetry: entries (i, j) and (j, i) are not there at the same time. Rows are
  /// taken for equal where hashes of 128 bits are.
  [[nodiscard]] MatrixFindings findings() const;

 private:
  struct RowFindings {
    Eigen::Index infinite = 0;
    Eigen::Index negative = 0;
    bool constant = false;
    bool nonzero_diagonal = false;
    bool nearest_to_others = false;
    std::pair<std::uint64_t, std::uint64_t> hash;
  };
  static RowFindings check_row(const DistanceTable& rows, Eigen::Index row, Eigen::Index diagonal);
  void add_equal_rows(MatrixFindings& findings) const;

  bool square_;
  std::vector<RowFindings> rows_;
};

/// All of that of a whole matrix, asymmetry included where it is square. Parallel, the same answer for any number of
/// threads.
MatrixFindings check_matrix(const DistanceTable& distances, bool square);

}  // namespace shapegauge
