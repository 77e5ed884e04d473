// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <functional>
#include <span>
#include <vector>

#include "shapegauge/core/base/members.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Streaming evaluation of distance matrices: blocks of rows are computed, evaluated, written and discarded.

namespace shapegauge {

/// Half-open range [first, last) of rows of a distance matrix.
struct RowRange {
  Eigen::Index first = 0;  ///< index of the first row
  Eigen::Index last = 0;   ///< index after that of the last row
};

/// Callback for a block of consecutive rows of a distance matrix; `first` is the index of the first row of the block.
using RowVisitor = std::function<void(Eigen::Index first, const DistanceTable& rows)>;

/// Computes these rows of the distance matrix of the signatures and passes them to visit() in order, in blocks of at
/// most 128 MiB. The distances equal those of distance_matrix() to the bit. Parallel. Throws as check_signatures()
/// does, and the errors of visit().
void visit_distances(const NamedDistance& distance, const Signatures& signatures, const RowRange& rows,
                     const RowVisitor& visit);

/// Returns the largest finite distance from the first signature to the others (largest_finite()), to scale heat maps.
double largest_distance_from_first(const NamedDistance& distance, const Signatures& signatures);

/// Scores of the queries in a range of rows of a distance matrix: one QueryScores per evaluation protocol.
using RowScores = std::vector<QueryScores>;

SHAPEGAUGE_MEMBERS(QueryScores, measures, precisions, relevant, tied, first_tiers)

/// Evaluates a range of rows of a distance matrix with each of the evaluation options. visit() must pass these rows in
/// order to the visitor that it receives. Adds the time of the evaluation to `seconds`. Parallel. Throws as
/// RowEvaluator does.
RowScores evaluate_row_range(const RetrievalTask& task, std::span<const EvaluationOptions> evaluations,
                             const RowRange& rows, const std::function<void(const RowVisitor&)>& visit,
                             double& seconds);

/// Combines scores of ranges of rows into one evaluation per entry of `evaluations`. `parts` has the scores of
/// consecutive ranges, in order, which cover all rows of the matrix.
std::vector<Evaluation> evaluations_of(const RetrievalTask& task, std::span<const EvaluationOptions> evaluations,
                                       std::span<const RowScores> parts);

/// Writer of a `.npy` file with a square distance matrix, by rows.
class MatrixFile {
 public:
  /// Creates the file for a matrix of `models` rows and columns. Throws std::runtime_error "cannot write <path>:
  /// <reason>", as add() and close() do.
  MatrixFile(std::filesystem::path path, std::size_t models);

  /// Appends a block of rows to the file.
  void add(const DistanceTable& rows);
  void close();  ///< completes the file

 private:
  void check() const;  ///< throws std::runtime_error if writing has failed

  std::filesystem::path path_;  ///< path of the file, for messages
  std::ofstream file_;          ///< opened file
};

}  // namespace shapegauge
