// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Anomalies of a distance matrix. None prevents scores from being computed; each may indicate that the matrix is not
/// what it is assumed to be.
struct MatrixFindings {
  bool square = false;        ///< row i and column i are the same model
  Eigen::Index infinite = 0;  ///< entries off the diagonal, without those of infinite_rows
  Eigen::Index negative = 0;  ///< entries off the diagonal
  /// Pairs i < j with different entries (i, j) and (j, i); 0 if all of them differ by rounding only, that is, by at
  /// most 1e-12 of the largest finite |distance| off the diagonal.
  Eigen::Index asymmetric_pairs = 0;
  double largest_asymmetry = 0;  ///< maximum finite |(i, j) - (j, i)|; 0 if asymmetric_pairs is
  bool triangular = false;       ///< of every asymmetric pair one entry is 0, and these are more than half of all pairs
  Eigen::Index nonzero_diagonal = 0;  ///< finite entries
  /// Rows whose finite diagonal entry is the largest and not also the smallest; none in a matrix of distances.
  Eigen::Index rows_nearest_to_others = 0;
  Eigen::Index rows_at_zero = 0;  ///< rows whose smallest entry off the diagonal is 0 and not the largest
  std::vector<std::pair<Eigen::Index, Eigen::Index>>
      equal_rows;  ///< pairs of a row and the earlier row that it repeats
  std::vector<Eigen::Index>
      constant_rows;  ///< rows whose entries off the diagonal are all equal, but not infinite_rows
  std::vector<Eigen::Index> infinite_rows;  ///< rows whose entries off the diagonal are all infinite and positive
};

/// Detects anomalies of a matrix streamed in blocks of rows. Parallel; the findings depend neither on the number of
/// threads nor on the size of blocks.
class MatrixChecks {
 public:
  /// `square`: row i and column i are the same model, that is, the matrix has a diagonal.
  explicit MatrixChecks(bool square) : square_(square) {}

  /// Adds the next rows.
  void add(const DistanceTable& rows);

  /// Detects asymmetry. `rows` are rows of the matrix from `first` on; `mirrored` are as many of its columns from
  /// `first` on, without the rows before `first`. Call once for every row of a square matrix.
  void compare(const DistanceTable& rows, Eigen::Index first, const DistanceTable& mirrored);

  /// Returns the findings of all rows so far. Rows are compared by 128-bit hashes.
  [[nodiscard]] MatrixFindings findings() const;

 private:
  struct RowFindings {
    Eigen::Index infinite = 0;
    Eigen::Index negative = 0;
    double largest = 0;  // finite
    bool constant = false;
    bool unreachable = false;
    bool nonzero_diagonal = false;
    bool nearest_to_others = false;
    bool at_zero = false;
    std::pair<std::uint64_t, std::uint64_t> hash;
  };
  static RowFindings check_row(const DistanceTable& rows, Eigen::Index row, Eigen::Index diagonal);
  void add_asymmetry(MatrixFindings& findings) const;
  void add_equal_rows(MatrixFindings& findings) const;

  bool square_;
  Eigen::Index asymmetric_pairs_ = 0;
  Eigen::Index infinite_asymmetries_ = 0;  // pairs whose difference is infinite
  Eigen::Index one_sided_pairs_ = 0;       // asymmetric pairs, one of which is 0
  double largest_asymmetry_ = 0;
  std::vector<RowFindings> rows_;
};

}  // namespace shapegauge
