#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// What is odd about a matrix of distances. None of it keeps scores from being computed; each may mean that the matrix
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

/// Looks for what is odd about a matrix that comes a few rows at a time. In parallel; the same findings for any number
/// of threads and however many rows come at a time.
class MatrixChecks {
 public:
  /// `square`: row i and column i are the same model, so that there is a diagonal.
  explicit MatrixChecks(bool square) : square_(square) {}

  /// Adds the next rows.
  void add(const DistanceTable& rows);

  /// Looks for asymmetry: `rows` are the matrix's rows from `first` on, `mirrored` as many of its columns from `first`
  /// on, without the rows before `first`. To be called once for every row of a square matrix.
  void compare(const DistanceTable& rows, Eigen::Index first, const DistanceTable& mirrored);

  /// Of all rows so far. Rows count as equal if their 128-bit hashes are.
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
  Eigen::Index asymmetric_pairs_ = 0;
  double largest_asymmetry_ = 0;
  std::vector<RowFindings> rows_;
};

}  // namespace shapegauge
