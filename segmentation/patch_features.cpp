// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/patch_features.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

/// Returns, for each value, the share of the weight below it, plus half of that of equal values: from 0 to 1. NaN for
/// values that are not finite.
std::vector<double> ranks(const ScalarField& field) {
  std::vector<Eigen::Index> order;
  double whole = 0;
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    if (!std::isfinite(field.values[i])) continue;
    order.push_back(i);
    whole += field.weights[i];
  }
  std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return field.values[i]; });
  std::vector<double> result(static_cast<std::size_t>(field.values.size()), std::numeric_limits<double>::quiet_NaN());
  double below = 0;
  for (auto first = order.begin(); first != order.end();) {
    double equal = 0;
    auto last = first;
    for (; last != order.end() && field.values[*last] == field.values[*first]; ++last) equal += field.weights[*last];
    for (; first != last; ++first) {
      result[static_cast<std::size_t>(*first)] = whole > 0 ? (below + equal / 2) / whole : 0;
    }
    below += equal;
  }
  return result;
}

/// Returns patches x levels; the last row is that of the whole surface.
Eigen::MatrixXd cumulative_shares(std::span<const std::int32_t> patch, Eigen::Index patches, const ScalarField& field,
                                  int levels) {
  const std::vector<double> rank = ranks(field);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(patches + 1, levels);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(patches + 1);
  for (std::size_t i = 0; i < patch.size(); ++i) {
    if (std::isnan(rank[i])) continue;
    const double weight = field.weights[static_cast<Eigen::Index>(i)];
    // The lowest level (k + 1/2) / n that is not below the rank.
    const auto first = static_cast<Eigen::Index>(std::max(0.0, std::ceil(rank[i] * levels - 0.5)));
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
  if (levels < 1) throw InputError(fmt::format("the number of quantile levels must be at least 1, not {}", levels));
  if (fields.empty() || patch.empty()) {
    throw ArgumentError(fmt::format("features of patches need at least 1 field and 1 sample, not {} and {}",
                                    fields.size(), patch.size()));
  }
  const Eigen::Index patches = *std::ranges::max_element(patch) + 1;
  Eigen::MatrixXd features(patches, std::ssize(fields) * levels);
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].values.size() != std::ssize(patch) || fields[f].weights.size() != std::ssize(patch)) {
      throw ArgumentError(fmt::format("field {} (counted from 0) has {} values and {} weights for {} samples", f,
                                      fields[f].values.size(), fields[f].weights.size(), patch.size()));
    }
    const Eigen::MatrixXd shares = cumulative_shares(patch, patches, fields[f], levels);
    features.middleCols(static_cast<Eigen::Index>(f) * levels, levels) = shares.topRows(patches);
  }
  return features;
}

}  // namespace shapegauge
