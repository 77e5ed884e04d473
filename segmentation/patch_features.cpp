#include "shapegauge/segmentation/patch_features.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

/// Patches x levels; the last row is the whole surface's.
Eigen::MatrixXd cumulative_shares(std::span<const std::int32_t> patch, Eigen::Index patches, const ScalarField& field,
                                  int levels) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(patches + 1, levels);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(patches + 1);
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const double value = field.values[static_cast<Eigen::Index>(i)];
    if (!std::isfinite(value)) continue;
    const double weight = field.weights[static_cast<Eigen::Index>(i)];
    const double place = greatest > least ? (value - least) / (greatest - least) : 0;
    // The least level (k + 1/2) / n that is not below the place.
    const auto first = static_cast<Eigen::Index>(std::max(0.0, std::ceil(place * levels - 0.5)));
    for (const Eigen::Index row : {Eigen::Index{patch[i]}, patches}) {
      weights[row] += weight;
      if (first < levels) sums.row(row).tail(levels - first).array() += weight;
    }
  }
  const double whole = weights[patches];
  for (Eigen::Index row = patches; row >= 0; --row) {
    if (weights[row] > 0) {
      sums.row(row) /= weights[row];
    } else if (whole > 0) {
      sums.row(row) = sums.row(patches);
    }
  }
  return sums;
}

}  // namespace

Eigen::MatrixXd patch_features(std::span<const std::int32_t> patch, std::span<const ScalarField> fields, int levels) {
  if (levels < 1) throw InputError(fmt::format("a distribution needs at least 1 level, not {}", levels));
  if (fields.empty() || patch.empty()) throw std::invalid_argument("features of patches need a field and samples");
  const Eigen::Index patches = *std::ranges::max_element(patch) + 1;
  Eigen::MatrixXd features(patches, std::ssize(fields) * levels);
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].values.size() != std::ssize(patch) || fields[f].weights.size() != std::ssize(patch)) {
      throw std::invalid_argument("a field needs one value and one weight a sample");
    }
    const Eigen::MatrixXd shares = cumulative_shares(patch, patches, fields[f], levels);
    features.middleCols(static_cast<Eigen::Index>(f) * levels, levels) = shares.topRows(patches);
  }
  return features;
}

}  // namespace shapegauge
