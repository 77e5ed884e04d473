#include "shapegauge/retrieval/distance_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <vector>

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

/// Signatures that follow each other, as one span.
std::span<const float> rows_of(const Signatures& signatures, Eigen::Index first, Eigen::Index count) {
  return {signatures.data() + first * signatures.cols(), static_cast<std::size_t>(count * signatures.cols())};
}

/// Distances from signature i to `distances.size()` of them from `first` on.
void distances_to(const NamedDistance& distance, const Signatures& signatures, Eigen::Index i, Eigen::Index first,
                  std::span<double> distances) {
  const std::span<const float> from = rows_of(signatures, i, 1);
  const auto count = static_cast<Eigen::Index>(distances.size());
  if (distance.to_several != nullptr) {
    distance.to_several(from, rows_of(signatures, first, count), distances);
    return;
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    distances[static_cast<std::size_t>(k)] = distance.function(from, rows_of(signatures, first + k, 1));
  }
}

}  // namespace

std::vector<std::string> distance_names() {
  std::vector<std::string> names;
  for (const NamedDistance& distance : distances()) names.emplace_back(distance.name);
  return names;
}

DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance) {
  const NamedDistance& between = distance_of(distance);
  check_finite(signatures);
  check_domain(signatures, between);
  const Eigen::Index count = signatures.rows();
  DistanceMatrix matrix(count, count);
  matrix.diagonal().setZero();
  const tbb::blocked_range2d<Eigen::Index> all(0, count, tile_size, 0, count, tile_size);
  // Each pair i < j is computed once, by whichever thread has its tile, and by itself: threads cannot change a bit.
  tbb::parallel_for(all, [&](const tbb::blocked_range2d<Eigen::Index>& tile) {
    std::vector<double> distances(tile.cols().size());
    for (Eigen::Index i = tile.rows().begin(); i < tile.rows().end(); ++i) {
      const Eigen::Index first = std::max(i + 1, tile.cols().begin());
      if (first >= tile.cols().end()) continue;
      const std::span<double> found = std::span(distances).first(static_cast<std::size_t>(tile.cols().end() - first));
      distances_to(between, signatures, i, first, found);
      for (Eigen::Index j = first; j < tile.cols().end(); ++j) {
        matrix(i, j) = matrix(j, i) = found[static_cast<std::size_t>(j - first)];
      }
    }
  });
  return matrix;
}

DistanceMatrix distance_rows(const Signatures& signatures, Eigen::Index first, Eigen::Index count,
                             const std::string& distance) {
  const NamedDistance& between = distance_of(distance);
  if (first < 0 || count < 0 || first > signatures.rows() - count) {
    throw std::invalid_argument("there are no rows " + std::to_string(first) + " to " + std::to_string(first + count) +
                                " in a distance matrix of " + std::to_string(signatures.rows()));
  }
  check_finite(signatures);
  check_domain(signatures, between);
  DistanceMatrix rows(count, signatures.rows());
  const tbb::blocked_range2d<Eigen::Index> all(0, count, tile_size, 0, signatures.rows(), tile_size);
  tbb::parallel_for(all, [&](const tbb::blocked_range2d<Eigen::Index>& tile) {
    for (Eigen::Index i = tile.rows().begin(); i < tile.rows().end(); ++i) {
      double* begin = rows.data() + i * rows.cols() + tile.cols().begin();
      distances_to(between, signatures, first + i, tile.cols().begin(), {begin, tile.cols().size()});
    }
    for (Eigen::Index i = tile.rows().begin(); i < tile.rows().end(); ++i) {
      const Eigen::Index self = first + i;
      if (self >= tile.cols().begin() && self < tile.cols().end()) rows(i, self) = 0;
    }
  });
  return rows;
}

}  // namespace shapegauge
