// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/core/base/text.h"
#include "shapegauge/metrics/chance.h"

namespace shapegauge {

namespace {

std::string name_of_row(std::span<const std::string> ids, Eigen::Index row) {
  return printable(ids[static_cast<std::size_t>(row)], 60);
}

void warn_of_entries(const MatrixFindings& found, bool negated, std::vector<std::string>& warnings) {
  if (found.negative > 0 && !negated) {
    warnings.push_back(
        fmt::format("{} negative, which ranks before 0; if larger means more similar, use `similarity=true`",
                    count_text(found.negative, "distance is", "distances are")));
  }
  if (found.infinite > 0) {
    warnings.push_back(
        fmt::format("{} infinite: these models are tied at the end of the list (minus infinity: at the beginning)",
                    count_text(found.infinite, "distance is", "distances are")));
  }
}

bool looks_reversed(const MatrixFindings& found, Eigen::Index rows) { return 2 * found.rows_nearest_to_others > rows; }

std::string reversed_text(const MatrixFindings& found, Eigen::Index rows) {
  return fmt::format("in {} of {} rows the query is the farthest model from itself: this looks like a matrix of ",
                     found.rows_nearest_to_others, rows);
}

// Describes how many pairs of entries of an asymmetric matrix differ, and by how much.
std::string asymmetry_text(const MatrixFindings& found) {
  const std::string pairs = count_text(found.asymmetric_pairs, "pair", "pairs");
  if (found.triangular) {
    return fmt::format("the matrix is triangular: in {} of entries (i, j) and (j, i) one is 0; complete it", pairs);
  }
  const std::string amount = found.largest_asymmetry > 0 ? fmt::format("by up to {:.6g}", found.largest_asymmetry)
                                                         : "as one is infinite and the other is not";
  return fmt::format("the matrix is not symmetric: {} of entries (i, j) and (j, i) differ, {}", pairs, amount);
}

void warn_of_square(const MatrixFindings& found, Eigen::Index rows, bool negated, std::vector<std::string>& warnings) {
  if (looks_reversed(found, rows)) {
    warnings.push_back(fmt::format("{}{} `similarity=true`; scores of the wrong kind are near 0",
                                   reversed_text(found, rows),
                                   negated ? "distances, which take no" : "similarities, which take"));
  }
  if (found.asymmetric_pairs > 0) {
    warnings.push_back(fmt::format("{}; query i is answered by row i, not by column i", asymmetry_text(found)));
  }
  if (found.nonzero_diagonal > 0 && !negated) {
    warnings.push_back(fmt::format("{} not 0 on the diagonal, which is ignored",
                                   count_text(found.nonzero_diagonal, "entry is", "entries are")));
  }
}

void warn_of_zeros(const MatrixFindings& found, Eigen::Index rows, bool negated, std::vector<std::string>& warnings) {
  if (negated || rows < 2 || found.rows_at_zero < rows) return;
  warnings.emplace_back(
      found.square ? "each query has another model at distance 0: duplicates in the data set, or rounded distances"
                   : "each query has a model at distance 0; if queries are among the targets, they find themselves: "
                     "evaluate the matrix of all models, or one with ids");
}

void warn_of_rows(const MatrixFindings& found, std::span<const std::string> ids, std::vector<std::string>& warnings) {
  auto repeated = found.equal_rows;  // constant and infinite rows have warnings of their own
  std::erase_if(repeated, [&](const auto& rows) {
    return std::ranges::binary_search(found.constant_rows, rows.first) ||
           std::ranges::binary_search(found.infinite_rows, rows.first);
  });
  if (!repeated.empty()) {
    const auto& [row, earlier] = repeated.front();
    warnings.push_back(fmt::format(
        "{} an earlier one (first: {} repeats {}): duplicates in the data set retrieve each other, which increases all "
        "scores",
        count_text(std::ssize(repeated), "row repeats", "rows repeat"), name_of_row(ids, row),
        name_of_row(ids, earlier)));
  }
  if (!found.constant_rows.empty()) {
    warnings.push_back(fmt::format("{} all distances equal (first: {}): only `ties` determines their order",
                                   count_text(std::ssize(found.constant_rows), "row has", "rows have"),
                                   name_of_row(ids, found.constant_rows.front())));
  }
  if (!found.infinite_rows.empty()) {
    warnings.push_back(
        fmt::format("{} at infinite distance from all models (first: {}): no model is found, and the "
                    "scores are 0",
                    count_text(std::ssize(found.infinite_rows), "query is", "queries are"),
                    name_of_row(ids, found.infinite_rows.front())));
  }
}

}  // namespace

std::vector<std::string> matrix_warnings(const MatrixFindings& found, std::span<const std::string> ids, bool negated) {
  std::vector<std::string> warnings;
  warn_of_entries(found, negated, warnings);
  warn_of_square(found, static_cast<Eigen::Index>(ids.size()), negated, warnings);
  warn_of_zeros(found, static_cast<Eigen::Index>(ids.size()), negated, warnings);
  warn_of_rows(found, ids, warnings);
  return warnings;
}

std::vector<std::string> rerank_warnings(const OpenMatrix& matrix) {
  constexpr Eigen::Index together = 256;
  MatrixChecks checks(true);
  for (Eigen::Index first = 0; first < matrix.rows; first += together) {
    const Eigen::Index count = std::min(together, matrix.rows - first);
    const DistanceMatrix rows =
        matrix.read({.first_row = first, .rows = count, .first_column = 0, .columns = matrix.columns});
    checks.add(rows);
    checks.compare(
        rows, first,
        matrix.read({.first_row = first, .rows = matrix.rows - first, .first_column = first, .columns = count}));
  }
  const MatrixFindings found = checks.findings();
  std::vector<std::string> warnings;
  if (looks_reversed(found, matrix.rows)) {
    warnings.push_back(fmt::format("{}similarities; re-ranking takes distances, the smallest of which are nearest",
                                   reversed_text(found, matrix.rows)));
  }
  if (found.asymmetric_pairs > 0) {
    warnings.push_back(fmt::format("{}; the neighbours of model i are taken from row i", asymmetry_text(found)));
  }
  return warnings;
}

std::optional<std::string> ties_warning(const Evaluation& evaluation, const MatrixFindings& found) {
  const auto known = std::ranges::count_if(
      found.constant_rows, [&](Eigen::Index row) { return std::ranges::binary_search(evaluation.queries, row); });
  if (evaluation.queries_with_ties <= known) return std::nullopt;
  const auto& [pessimistic, optimistic] = evaluation.first_tier_bounds;
  return fmt::format(
      "the answers to {} of {} queries have relevant and other models at equal distance; they are ordered by "
      "`ties={}`{}",
      evaluation.queries_with_ties, evaluation.queries.size(), name_of(evaluation.ties),
      pessimistic == optimistic
          ? ""
          : fmt::format("; FT ranges from {:.1f} to {:.1f} with their order", 100 * pessimistic, 100 * optimistic));
}

std::optional<std::string> chance_warning(const Evaluation& evaluation, const MatrixFindings& found,
                                          const RetrievalTask& task) {
  constexpr double improbable = 1e-4;
  const bool has_reason =
      !found.infinite_rows.empty() || 2 * evaluation.queries_with_ties > std::ssize(evaluation.queries);
  const auto chance = has_reason ? std::nullopt : compare_nearest_with_chance(evaluation, task);
  if (!chance || chance->probability > improbable) return std::nullopt;
  return fmt::format(
      "NN is {:.1f} %, far below the {:.1f} % of a random order: rows may be in another order than the labels, or the "
      "values may be similarities read as distances, or the reverse",
      100 * chance->found, 100 * chance->expected);
}

std::optional<std::string> left_out_warning(const Evaluation& evaluation, const RetrievalTask& task,
                                            const EvaluationOptions& options) {
  if (evaluation.excluded_models == 0) return std::nullopt;
  const int minimum = std::max(options.minimum_class_size, 2);
  return task.judged.empty() ? fmt::format("omitted as queries: {} of classes with fewer than {} models",
                                           count_text(evaluation.excluded_models, "model", "models"), minimum)
                             : fmt::format("omitted from all scores: {} with fewer than {} relevant models",
                                           count_text(evaluation.excluded_models, "query", "queries"), minimum - 1);
}

}  // namespace shapegauge
