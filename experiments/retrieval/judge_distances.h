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

/// Streamed distances: blocks of rows are computed, evaluated, written and discarded.

namespace shapegauge {

/// Half-open range of rows of a distance matrix.
struct RowRange {
  Eigen::Index first = 0;
  Eigen::Index last = 0;
};

/// Receives rows of a distance matrix, from the row `first` on.
using RowVisitor = std::function<void(Eigen::Index first, const DistanceTable& rows)>;

/// Calls visit() with these rows of the distance matrix of the signatures, in blocks of at most 128 MiB, in order.
/// Equal to distance_matrix() to the bit. Parallel. Throws as check_signatures() does, and the errors of visit().
void visit_distances(const NamedDistance& distance, const Signatures& signatures, const RowRange& rows,
                     const RowVisitor& visit);

/// Returns largest_finite() of the first row of the distance matrix.
double largest_of_first(const NamedDistance& distance, const Signatures& signatures);

/// Scores of the queries among some rows, by evaluation.
using RowScores = std::vector<QueryScores>;

SHAPEGAUGE_MEMBERS(QueryScores, measures, precisions, relevant, tied, first_tiers)

/// Evaluates rows of a distance matrix, which visit() passes to its visitor in order. Parallel. Adds the seconds of
/// evaluation. Throws as RowEvaluator does.
RowScores judge_rows(const RetrievalTask& task, std::span<const EvaluationOptions> evaluations, const RowRange& rows,
                     const std::function<void(const RowVisitor&)>& visit, double& seconds);

/// Combines the scores of all rows, which `parts` have in order.
std::vector<Evaluation> evaluations_of(const RetrievalTask& task, std::span<const EvaluationOptions> evaluations,
                                       std::span<const RowScores> parts);

/// `.npy` file of a square matrix, written by rows.
class MatrixFile {
 public:
  /// Throws std::runtime_error "cannot write <path>: <reason>", as the other functions do.
  MatrixFile(std::filesystem::path path, std::size_t models);

  /// Appends rows.
  void add(const DistanceTable& rows);
  void close();

 private:
  void check() const;

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace shapegauge
