// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/judge_distances.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <fmt/format.h>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/metrics/distance_overview.h"

namespace shapegauge {

namespace {

/// Returns the number of rows computed together, limited by their memory.
Eigen::Index rows_together(Eigen::Index all) {
  constexpr Eigen::Index max_bytes = Eigen::Index{128} << 20;
  return std::clamp<Eigen::Index>(max_bytes / Eigen::Index{sizeof(double)} / std::max<Eigen::Index>(all, 1), 1, 4096);
}

/// Computes rows of the matrix, from the row `begin` on, in groups that stay in the processor's cache until they are
/// stored.
void compute_rows(const NamedDistance& distance, const Signatures& signatures, Eigen::Index begin,
                  Eigen::Ref<DistanceMatrix> distances) {
  constexpr Eigen::Index together = 32;
  parallel_for(Eigen::Index{0}, (distances.rows() + together - 1) / together, [&](Eigen::Index group) {
    const Eigen::Index first = group * together;
    const Eigen::Index count = std::min(together, distances.rows() - first);
    distances.middleRows(first, count) =
        distances_between(distance, {signatures.middleRows(begin + first, count), begin + first}, {signatures, 0});
  });
}

template <typename Number>
void append(std::vector<Number>& all, const std::vector<Number>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Concatenates the scores of one evaluation.
QueryScores together(std::span<const RowScores> parts, std::size_t evaluation) {
  Eigen::Index queries = 0;
  for (const RowScores& part : parts) queries += part[evaluation].measures.rows();
  const QueryScores& front = parts.front()[evaluation];
  QueryScores scores;
  scores.measures.resize(queries, front.measures.cols());
  scores.precisions.resize(queries, front.precisions.cols());
  scores.first_tiers.resize(queries, Eigen::NoChange);
  Eigen::Index first = 0;
  for (const RowScores& rows : parts) {
    const QueryScores& part = rows[evaluation];
    scores.measures.middleRows(first, part.measures.rows()) = part.measures;
    scores.precisions.middleRows(first, part.measures.rows()) = part.precisions;
    scores.first_tiers.middleRows(first, part.measures.rows()) = part.first_tiers;
    append(scores.relevant, part.relevant);
    append(scores.tied, part.tied);
    first += part.measures.rows();
  }
  return scores;
}

}  // namespace

void visit_distances(const NamedDistance& distance, const Signatures& signatures, const RowRange& rows,
                     const RowVisitor& visit) {
  check_signatures({signatures, 0}, distance);
  const Eigen::Index at_once = std::min(rows_together(signatures.rows()), rows.last - rows.first);
  DistanceMatrix block(at_once, signatures.rows());
  for (Eigen::Index first = rows.first; first < rows.last; first += at_once) {
    const Eigen::Index count = std::min(at_once, rows.last - first);
    compute_rows(distance, signatures, first, block.topRows(count));
    visit(first, block.topRows(count));
  }
}

double largest_distance_from_first(const NamedDistance& distance, const Signatures& signatures) {
  const DistanceMatrix row = distances_between(distance, {signatures.topRows(1), 0}, {signatures, 0});
  return largest_finite({row.data(), static_cast<std::size_t>(row.size())}, 0);
}

RowScores evaluate_row_range(const RetrievalTask& task, std::span<const EvaluationOptions> evaluations,
                             const RowRange& rows, const std::function<void(const RowVisitor&)>& visit,
                             double& seconds) {
  std::vector<RowEvaluator> evaluators;
  for (const EvaluationOptions& options : evaluations) evaluators.emplace_back(task, options, rows.first, rows.last);
  visit([&](Eigen::Index first, const DistanceTable& some) {
    const Stopwatch stopwatch;
    for (RowEvaluator& evaluator : evaluators) evaluator.evaluate(some, first);
    seconds += stopwatch.seconds();
  });
  RowScores scores;
  for (const RowEvaluator& evaluator : evaluators) scores.push_back(evaluator.scores());
  return scores;
}

std::vector<Evaluation> evaluations_of(const RetrievalTask& task, std::span<const EvaluationOptions> evaluations,
                                       std::span<const RowScores> parts) {
  std::vector<Evaluation> combined;
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    combined.push_back(RowEvaluator(task, evaluations[i], 0, 0).evaluation_of(together(parts, i)));
  }
  return combined;
}

MatrixFile::MatrixFile(std::filesystem::path path, std::size_t models)
    : path_(std::move(path)), file_(path_, std::ios::binary | std::ios::trunc) {
  file_ << npy_header_of_matrix(models, models);
  check();
}

void MatrixFile::add(const DistanceTable& rows) {
  file_ << npy_numbers({rows.data(), static_cast<std::size_t>(rows.size())});
  check();
}

void MatrixFile::close() {
  file_.close();
  check();
}

void MatrixFile::check() const {
  if (file_) return;
  throw std::runtime_error(fmt::format("cannot write {}: {}", path_.string(), std::generic_category().message(errno)));
}

}  // namespace shapegauge
