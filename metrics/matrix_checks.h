// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Anomalies of a distance matrix, found by MatrixChecks. Scores can be computed in spite of them, but each may
/// indicate an error in the matrix.
struct MatrixFindings {
  bool square = false;        ///< true if row i and column i are the same model for each i
  Eigen::Index infinite = 0;  ///< number of infinite off-diagonal entries, except for those in `infinite_rows`
  Eigen::Index negative = 0;  ///< number of negative off-diagonal entries
  /// Number of pairs i < j with different entries (i, j) and (j, i); 0 if all differences are due to rounding, that is,
  /// at most 1e-12 of the largest finite |distance| off the diagonal.
  Eigen::Index asymmetric_pairs = 0;
  double largest_asymmetry = 0;  ///< maximum finite difference of entries (i, j) and (j, i); 0 if asymmetric_pairs is 0
  bool triangular = false;       ///< true if over half of all pairs i < j are asymmetric, all with an entry of 0
  Eigen::Index nonzero_diagonal = 0;  ///< number of finite diagonal entries other than 0
  /// Number of rows whose finite diagonal entry is the maximum of the row and not also the minimum, as in a matrix of
  /// similarities.
  Eigen::Index rows_nearest_to_others = 0;
  Eigen::Index rows_at_zero = 0;  ///< number of rows whose smallest off-diagonal entry is 0 and the largest is not
  std::vector<std::pair<Eigen::Index, Eigen::Index>>
      equal_rows;  ///< pairs of row indices: a row, and the first row equal to it
  std::vector<Eigen::Index>
      constant_rows;  ///< indices of rows whose off-diagonal entries are all equal, except `infinite_rows`
  std::vector<Eigen::Index> infinite_rows;  ///< indices of rows whose off-diagonal entries are all +infinity
};

/// Detects anomalies of a distance matrix streamed in blocks of rows. Parallel; the findings depend neither on the
/// number of threads nor on the size of blocks.
class MatrixChecks {
 public:
  /// Starts the checks of a matrix. `square` states that row i and column i are the same model, so that there is a
  /// diagonal.
  explicit MatrixChecks(bool square) : square_(square) {}

  /// Checks the next rows of the matrix for all anomalies except asymmetry.
  void add(const DistanceTable& rows);

  /// Detects asymmetry. `rows` are n consecutive rows of the matrix from row `first` on. `mirrored` are the n columns
  /// from column `first` on, without the rows above `first`. The calls must cover each row of a square
  /// matrix once; findings() has the result.
  void compare(const DistanceTable& rows, Eigen::Index first, const DistanceTable& mirrored);

  /// Returns the findings of all rows so far. Equal rows are detected by 128-bit hashes.
  [[nodiscard]] MatrixFindings findings() const;

 private:
  struct RowFindings {                             // anomalies of one row
    Eigen::Index infinite = 0;                     // number of infinite entries off the diagonal
    Eigen::Index negative = 0;                     // number of negative entries off the diagonal
    double largest = 0;                            // largest finite |entry| off the diagonal
    bool constant = false;                         // all entries off the diagonal are equal, and not +infinity
    bool unreachable = false;                      // all entries off the diagonal are +infinity
    bool nonzero_diagonal = false;                 // the diagonal entry is finite and not 0
    bool nearest_to_others = false;                // the diagonal entry is the maximum, not the minimum
    bool at_zero = false;                          // the smallest entry off the diagonal is 0, the largest not
    std::pair<std::uint64_t, std::uint64_t> hash;  // hash of all entries, to detect equal rows
  };
  // Checks row `row` of `rows`, whose diagonal entry is in the column `diagonal`; -1 for none.
  static RowFindings check_row(const DistanceTable& rows, Eigen::Index row, Eigen::Index diagonal);
  void add_asymmetry(MatrixFindings& findings) const;   // sets the findings about pairs (i, j) and (j, i)
  void add_equal_rows(MatrixFindings& findings) const;  // sets MatrixFindings::equal_rows

  bool square_;                            // true if there is a diagonal
  Eigen::Index asymmetric_pairs_ = 0;      // number of pairs i < j with different entries (i, j) and (j, i)
  Eigen::Index infinite_asymmetries_ = 0;  // number of asymmetric pairs whose difference is infinite
  Eigen::Index one_sided_pairs_ = 0;       // number of asymmetric pairs with one entry 0
  double largest_asymmetry_ = 0;           // maximum finite |(i, j) - (j, i)|
  std::vector<RowFindings> rows_;          // findings of the rows so far
};

}  // namespace shapegauge
