// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/distance_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tbb/blocked_range2d.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/parallel_parts.h"

namespace shapegauge {

namespace {

void check_finite(const SignatureBlock& block) {
  const auto& signatures = block.signatures;
  for (Eigen::Index row = 0; row < signatures.rows(); ++row) {
    if ((signatures.row(row).array() * 0).sum() == 0) continue;  // NaN where an entry is not finite
    for (Eigen::Index column = 0; column < signatures.cols(); ++column) {
      if (std::isfinite(signatures(row, column))) continue;
      throw ArgumentError("entry " + std::to_string(column) + " of signature " + std::to_string(block.first + row) +
                          " (both counted from 0) is not a finite number");
    }
  }
}

void check_domain(const SignatureBlock& block, const NamedDistance& distance) {
  if (distance.domain == DistanceDomain::any) return;
  const auto& signatures = block.signatures;
  const bool may_be_negative = distance.domain == DistanceDomain::not_zero;
  const bool may_be_zero = distance.domain == DistanceDomain::not_negative;
  for (Eigen::Index row = 0; row < signatures.rows(); ++row) {
    const bool negative = (signatures.row(row).array() < 0).any();
    const bool zero = (signatures.row(row).array() == 0).all();
    if ((may_be_negative || !negative) && (may_be_zero || !zero)) continue;
    throw ArgumentError("the distance " + distance.name + " is not defined for signature " +
                        std::to_string(block.first + row) + " (counted from 0), which " +
                        (zero ? "is zero" : "has a negative entry") + "; l1 and l2 take any signature");
  }
}

/// Consecutive signatures: indices [first, last) in the set.
struct Stretch {
  Eigen::Index first;
  Eigen::Index last;

  [[nodiscard]] Eigen::Index size() const { return last - first; }
};

/// Returns those signatures of the block as one span.
std::span<const float> numbers_of(const SignatureBlock& block, const Stretch& some) {
  const Eigen::Index length = block.signatures.cols();
  return {block.signatures.data() + (some.first - block.first) * length,
          static_cast<std::size_t>(some.size() * length)};
}

std::span<const float> numbers_of(const SignatureBlock& block, Eigen::Index signature) {
  return numbers_of(block, Stretch{signature, signature + 1});
}

/// Returns the number of signatures of a tile: two tiles in double precision fit into a core's cache.
Eigen::Index tile_size(const SignatureBlock& block) {
  constexpr Eigen::Index entries = 32768;
  return std::clamp<Eigen::Index>(entries / std::max<Eigen::Index>(block.signatures.cols(), 1), 8, 32);
}

/// Range divided into tiles.
struct Tiles {
  Stretch whole;
  Eigen::Index size;

  explicit Tiles(const SignatureBlock& block)
      : whole{block.first, block.first + block.signatures.rows()}, size(tile_size(block)) {}

  [[nodiscard]] Eigen::Index count() const { return (whole.size() + size - 1) / size; }
  [[nodiscard]] Stretch at(Eigen::Index index) const {
    const Eigen::Index first = whole.first + index * size;
    return {first, std::min(first + size, whole.last)};
  }
};

/// Computes distances from each signature of `rows` to each of `columns`, except to itself.
DistanceMatrix tile_distances(const NamedDistance& distance, const SignatureBlock& some, const Stretch& rows,
                              const SignatureBlock& others, const Stretch& columns) {
  check_interruption();  // TBB's subranges may take seconds
  DistanceMatrix tile(rows.size(), columns.size());
  if (distance.batch != nullptr) {
    distance.batch(numbers_of(some, rows), numbers_of(others, columns),
                   static_cast<std::size_t>(some.signatures.cols()),
                   {tile.data(), static_cast<std::size_t>(tile.size())});
    return tile;
  }
  for (Eigen::Index i = rows.first; i < rows.last; ++i) {
    check_interruption();
    for (Eigen::Index j = columns.first; j < columns.last; ++j) {
      // One call for both orders: with contraction of operations, (a, b) and (b, a) may differ in the last bit.
      const std::span<const float> a = numbers_of(some, i);
      const std::span<const float> b = numbers_of(others, j);
      tile(i - rows.first, j - columns.first) = i == j ? 0 : i < j ? distance.function(a, b) : distance.function(b, a);
    }
  }
  return tile;
}

}  // namespace

void check_signatures(const SignatureBlock& block, const NamedDistance& distance) {
  check_finite(block);
  check_domain(block, distance);
}

DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance) {
  return distance_matrix(signatures, distances().at(distance));
}

DistanceMatrix distance_matrix(const Signatures& signatures, const NamedDistance& distance) {
  const SignatureBlock block{signatures, 0};
  check_signatures(block, distance);
  const Tiles all(block);
  DistanceMatrix matrix(signatures.rows(), signatures.rows());
  const tbb::blocked_range2d<Eigen::Index> tiles(0, all.count(), 0, all.count());
  // Each pair is computed once, within one tile: results do not depend on the threads.
  interruptible_parallel_for(tiles, [&](const tbb::blocked_range2d<Eigen::Index>& some) {
    for (Eigen::Index i = some.rows().begin(); i < some.rows().end(); ++i) {
      for (Eigen::Index j = std::max(i, some.cols().begin()); j < some.cols().end(); ++j) {
        const Stretch rows = all.at(i);
        const Stretch columns = all.at(j);
        const DistanceMatrix tile = tile_distances(distance, block, rows, block, columns);
        matrix.block(rows.first, columns.first, rows.size(), columns.size()) = tile;
        matrix.block(columns.first, rows.first, columns.size(), rows.size()) = tile.transpose();
      }
    }
  });
  matrix.diagonal().setZero();
  return matrix;
}

DistanceMatrix distances_between(const NamedDistance& distance, const SignatureBlock& some,
                                 const SignatureBlock& others) {
  const Tiles rows(some);
  const Tiles columns(others);
  DistanceMatrix distances(rows.whole.size(), columns.whole.size());
  const tbb::blocked_range2d<Eigen::Index> tiles(0, rows.count(), 0, columns.count());
  interruptible_parallel_for(tiles, [&](const tbb::blocked_range2d<Eigen::Index>& part) {
    for (Eigen::Index i = part.rows().begin(); i < part.rows().end(); ++i) {
      for (Eigen::Index j = part.cols().begin(); j < part.cols().end(); ++j) {
        const Stretch of = rows.at(i);
        const Stretch to = columns.at(j);
        distances.block(of.first - some.first, to.first - others.first, of.size(), to.size()) =
            tile_distances(distance, some, of, others, to);
      }
    }
  });
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    const Eigen::Index itself = some.first + i - others.first;
    if (itself >= 0 && itself < distances.cols()) distances(i, itself) = 0;
  }
  return distances;
}

DistanceMatrix distance_rows(const Signatures& signatures, Eigen::Index first, Eigen::Index count,
                             const NamedDistance& distance) {
  if (first < 0 || count < 0 || first > signatures.rows() - count) {
    throw ArgumentError("there are no rows " + std::to_string(first) + " to " + std::to_string(first + count) +
                        " in a distance matrix of " + std::to_string(signatures.rows()));
  }
  const SignatureBlock all{signatures, 0};
  check_signatures(all, distance);
  return distances_between(distance, {signatures.middleRows(first, count), first}, all);
}

}  // namespace shapegauge
