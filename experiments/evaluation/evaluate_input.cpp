#include "shapegauge/experiments/evaluation/evaluate_input.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

// "1 row", "3 rows"
std::string counted(Eigen::Index count, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

std::string name_of_row(std::span<const std::string> ids, Eigen::Index row) {
  return printable(ids[static_cast<std::size_t>(row)], 60);
}

void remark_entries(const MatrixFindings& found, bool negated, std::vector<std::string>& remarks) {
  if (found.negative > 0 && !negated) {
    remarks.push_back(
        fmt::format("{} negative: taken as nearer than 0, in their order; if larger means more alike, use "
                    "--similarity",
                    counted(found.negative, "distance is", "distances are")));
  }
  if (found.infinite > 0) {
    remarks.push_back(
        fmt::format("{} infinite: such models are tied at the end of the list (or, minus infinity, at its "
                    "beginning)",
                    counted(found.infinite, "distance is", "distances are")));
  }
}

void remark_square(const MatrixFindings& found, Eigen::Index rows, bool negated, std::vector<std::string>& remarks) {
  if (2 * found.rows_nearest_to_others > rows) {
    remarks.push_back(
        fmt::format("in {} of {} rows the query is the farthest model from itself: this looks like a "
                    "matrix of {}; figures of the wrong kind are near 0",
                    found.rows_nearest_to_others, rows,
                    negated ? "distances, which take no --similarity" : "similarities, which take --similarity"));
  }
  if (found.asymmetric_pairs > 0) {
    remarks.push_back(
        fmt::format("the matrix is not symmetric: {} of entries (i, j) and (j, i) differ, by up to {:.6g}; "
                    "row i, not column i, is the answer to query i",
                    counted(found.asymmetric_pairs, "pair", "pairs"), found.largest_asymmetry));
  }
  if (found.nonzero_diagonal > 0 && !negated) {
    remarks.push_back(
        fmt::format("{} not 0 on the diagonal, which plays no part, because a query is left out of "
                    "its answer by its index",
                    counted(found.nonzero_diagonal, "entry is", "entries are")));
  }
}

void remark_rows(const MatrixFindings& found, std::span<const std::string> ids, std::vector<std::string>& remarks) {
  if (!found.equal_rows.empty()) {
    const auto& [row, earlier] = found.equal_rows.front();
    remarks.push_back(
        fmt::format("{} an earlier one (first: {} repeats {}): duplicates in the data set find each other, "
                    "which makes all figures larger",
                    counted(std::ssize(found.equal_rows), "row repeats", "rows repeat"), name_of_row(ids, row),
                    name_of_row(ids, earlier)));
  }
  if (!found.constant_rows.empty()) {
    remarks.push_back(fmt::format("{} all distances equal (first: {}): their answers have no order but that of ties",
                                  counted(std::ssize(found.constant_rows), "row has", "rows have"),
                                  name_of_row(ids, found.constant_rows.front())));
  }
}

}  // namespace

std::vector<std::string> matrix_warnings(const MatrixFindings& findings, std::span<const std::string> ids,
                                         bool negated) {
  std::vector<std::string> remarks;
  remark_entries(findings, negated, remarks);
  remark_square(findings, static_cast<Eigen::Index>(ids.size()), negated, remarks);
  remark_rows(findings, ids, remarks);
  return remarks;
}

namespace {

CheckedEvaluation by_rows(const ComparedFeatures& compared, const EvaluationInput& input,
                          const EvaluationOptions& options) {
  MatrixChecks checks(input.same_rows_and_columns);
  const DistanceRows distances = [&](Eigen::Index first, Eigen::Index count) {
    DistanceMatrix rows = distance_rows(compared.features, first, count, compared.distance);
    checks.add(rows);
    return rows;
  };
  Evaluation evaluation = evaluate(distances, input.task, options);
  return {.evaluation = std::move(evaluation), .findings = checks.findings()};
}

}  // namespace

CheckedEvaluation evaluate_and_check(const EvaluationInput& input, const EvaluationOptions& options) {
  if (input.features) return by_rows(*input.features, input, options);
  CheckedEvaluation result{.evaluation = evaluate(input.distances, input.task, options), .findings = {}};
  if (!input.task.lists_may_end_early) {
    result.findings = check_matrix(input.distances, input.same_rows_and_columns);
  }
  return result;
}

}  // namespace shapegauge
