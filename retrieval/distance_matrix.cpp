#include "shapegauge/retrieval/distance_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include "shapegauge/retrieval/distances/registry.h"

namespace shapegauge {
namespace {

constexpr Eigen::Index tile_size =
    32;  // two tiles of signatures of a few hundred entries stay in the first-level cache

const NamedDistance& distance_of(const std::string& name) {
  const auto known = distances();
  const auto found = std::ranges::find(known, name, &NamedDistance::name);
  if (found != known.end()) return *found;
  std::string message = "there is no distance named \"" + name + "\"; known are:";
  for (const NamedDistance& distance : known) message.append(" ").append(distance.name);
  throw std::invalid_argument(message);
}

void check_finite(const Signatures& signatures) {
  for (Eigen::Index row = 0; row < signatures.rows(); ++row) {
    for (Eigen::Index column = 0; column < signatures.cols(); ++column) {
      if (std::isfinite(signatures(row, column))) continue;
      throw std::invalid_argument("entry " + std::to_string(column) + " of signature " + std::to_string(row) +
                                  " (both counted from 0) is not a finite number");
    }
  }
}

void check_domain(const Signatures& signatures, const NamedDistance& distance) {
  const bool may_be_negative = distance.domain == DistanceDomain::any || distance.domain == DistanceDomain::not_zero;
  const bool may_be_zero = distance.domain == DistanceDomain::any || distance.domain == DistanceDomain::not_negative;
  for (Eigen::Index row = 0; row < signatures.rows(); ++row) {
    const bool negative = (signatures.row(row).array() < 0).any();
    const bool zero = (signatures.row(row).array() == 0).all();
    if ((may_be_negative || !negative) && (may_be_zero || !zero)) continue;
    throw std::invalid_argument("the distance " + std::string(distance.name) + " is not defined for signature " +
                                std::to_string(row) + " (counted from 0), which " +
                                (zero ? "is zero" : "has a negative entry") + "; l1 and l2 take any signature");
  }
}

std::span<const float> row_of(const Signatures& signatures, Eigen::Index row) {
  const auto length = static_cast<std::size_t>(signatures.cols());
  return {signatures.data() + row * signatures.cols(), length};
}

}  // namespace

std::vector<std::string> distance_names() {
  std::vector<std::string> names;
  for (const NamedDistance& distance : distances()) names.emplace_back(distance.name);
  return names;
}

DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance) {
  const NamedDistance& named = distance_of(distance);
  check_finite(signatures);
  check_domain(signatures, named);
  const DistanceFunction between = named.function;
  const Eigen::Index count = signatures.rows();
  DistanceMatrix matrix = DistanceMatrix::Zero(count, count);
  const tbb::blocked_range2d<Eigen::Index> all(0, count, tile_size, 0, count, tile_size);
  // Each pair i < j is computed once, by whichever thread has its tile, and by itself: threads cannot change a bit.
  tbb::parallel_for(all, [&](const tbb::blocked_range2d<Eigen::Index>& tile) {
    for (Eigen::Index i = tile.rows().begin(); i < tile.rows().end(); ++i) {
      for (Eigen::Index j = std::max(i + 1, tile.cols().begin()); j < tile.cols().end(); ++j) {
        matrix(i, j) = matrix(j, i) = between(row_of(signatures, i), row_of(signatures, j));
      }
    }
  });
  return matrix;
}

}  // namespace shapegauge
