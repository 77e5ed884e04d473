// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/feature_checks.h"

#include <cstddef>
#include <cstdint>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/single_precision.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

constexpr double negligible_rounding = 1e-4;  // of the spread of features

bool are_distances(const DistanceMatrix& table) {
  if (table.rows() != table.cols() || table.rows() < 3) return false;
  const double rounding = 1e-6 * table.cwiseAbs().maxCoeff();
  return rounding > 0 && table.diagonal().cwiseAbs().maxCoeff() <= rounding &&
         (table - table.transpose()).cwiseAbs().maxCoeff() <= rounding;
}

// Returns the sum of the rounding errors divided by that of the deviations from the columns' means.
double rounding_of_differences(const DistanceMatrix& features) {
  const double errors = (features - features.cast<float>().cast<double>()).cwiseAbs().sum();
  const Eigen::RowVectorXd mean = features.colwise().mean();
  const double deviations = (features.rowwise() - mean).cwiseAbs().sum();
  return errors > 0 && deviations > 0 ? errors / deviations : 0;
}

// Returns the column that is 0, 1, 2 ... or 1, 2, 3 ..., as the index of a table, if there is one among several.
std::optional<Eigen::Index> counting_column(const DistanceMatrix& features) {
  constexpr Eigen::Index min_rows = 10;
  if (features.rows() < min_rows || features.cols() < 2) return std::nullopt;
  const auto count = Eigen::VectorXd::LinSpaced(features.rows(), 0, static_cast<double>(features.rows() - 1)).eval();
  for (Eigen::Index column = 0; column < features.cols(); ++column) {
    const double first = features(0, column);
    if ((first == 0 || first == 1) && (features.col(column).array() - first == count.array()).all()) return column;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> check_features(const DistanceMatrix& features) {
  if (are_distances(features)) {
    throw InputError(
        "the table has distances, not features: it is square and symmetric with a zero diagonal; use it as it is, "
        "without `distance`");
  }
  if (const auto column = counting_column(features)) {
    throw InputError(fmt::format(
        "column {} (counted from 0) has the numbers of the rows, which are no feature; remove it", *column));
  }
  if (features.array().isFinite().all() && !features.cast<float>().array().isFinite().all()) {
    throw InputError(
        "a feature is larger than 3.4e38, the largest number of the single precision in which features are compared; "
        "scale "
        "the features");
  }
  const std::size_t merged = rows_merged_in_single_precision(
      {features.data(), static_cast<std::size_t>(features.size())}, static_cast<std::size_t>(features.cols()));
  const double rounding = rounding_of_differences(features);
  if (merged == 0 && rounding < negligible_rounding) return std::nullopt;
  const std::string effect =
      merged > 0 ? count_text(static_cast<std::int64_t>(merged), "row equals another from which it differs",
                              "rows equal others from which they differ")
                 : fmt::format("rounding is {:.2g} % of the spread of the features", 100 * rounding);
  return "features are compared in single precision, in which " + effect +
         "; subtract the mean of each column, or scale the features";
}

}  // namespace shapegauge
