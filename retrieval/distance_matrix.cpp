#include "shapegauge/retrieval/distance_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

NamedDistance distance_of(const std::string& name) {
  const std::vector<NamedDistance> known = distances();
  const auto found = std::ranges::find(known, name, &NamedDistance::name);
  if (found != known.end()) return *found;
  std::string message = "there is no distance named \"" + name + "\"; known are:";
  for (const NamedDistance& distance : known) message.append(" ").append(distance.name);
  throw std::invalid_argument(message);
}

void check_finite(const Signatures& signatures) {
  for (Eigen::Index row = 0; row < signatures.rows(); ++row) {
    if ((signatures.row(row).array() * 0).sum() == 0) continue;  // NaN where an entry is not finite
    for (Eigen::Index column = 0; column < signatures.cols(); ++column) {
      if (std::isfinite(signatures(row, column))) continue;
      throw std::invalid_argument("entry " + std::to_string(column) + " of signature " + std::to_string(row) +
                                  " (both counted from 0) is not a finite number");
    }
  }
}

void check_domain(const Signatures& signatures, const NamedDistance& distance) {
  if (distance.domain == DistanceDomain::any) return;
  const bool may_be_negative = distance.domain == DistanceDomain::any || distance.domain == DistanceDomain::not_zero;
  const bool may_be_zero = distance.domain == DistanceDomain::any || distance.domain == DistanceDomain::not_negative;
  for (Eigen::Index row = 0; row < signatures.rows(); ++row) {
    const bool negative = (signatures.row(row).array() < 0).any();
    const bool zero = (signatures.row(row).array() == 0).all();
    if ((may_be_negative || !negative) && (may_be_zero || !zero)) continue;
    throw std::invalid_argument("the distance " + distance.name + " is not defined for signature " +
                                std::to_string(row) + " (counted from 0), which " +
                                (zero ? "is zero" : "has a negative entry") + "; l1 and l2 take any signature");
  }
}

void check_signatures(const Signatures& signatures, const NamedDistance& distance) {
  check_finite(signatures);
  check_domain(signatures, distance);
}

/// Signatures that follow each other, as one span.
std::span<const float> rows_of(const Signatures& signatures, Eigen::Index first, Eigen::Index count) {
  return {signatures.data() + first * signatures.cols(), static_cast<std::size_t>(count * signatures.cols())};
}

/// Signatures that follow each other: their numbers from `first` to before `last`.
struct Stretch {
  Eigen::Index first;
  Eigen::Index last;

  [[nodiscard]] Eigen::Index size() const { return last - first; }
};

/// Signatures of a tile: so few that two tiles, in double precision, stay in a core's own cache.
Eigen::Index tile_size(const Signatures& signatures) {
  constexpr Eigen::Index entries = 32768;
  return std::clamp<Eigen::Index>(entries / std::max<Eigen::Index>(signatures.cols(), 1), 8, 32);
}

/// A stretch in tiles.
struct Tiles {
  Stretch whole;
  Eigen::Index size;

  [[nodiscard]] Eigen::Index count() const { return (whole.size() + size - 1) / size; }
  [[nodiscard]] Stretch at(Eigen::Index index) const {
    const Eigen::Index first = whole.first + index * size;
    return {first, std::min(first + size, whole.last)};
  }
};

/// Distances from each signature of `rows` to each of `columns`; those to itself do not count.
DistanceMatrix tile_distances(const NamedDistance& distance, const Signatures& signatures, const Stretch& rows,
                              const Stretch& columns) {
  DistanceMatrix tile(rows.size(), columns.size());
  if (distance.of_several != nullptr) {
    distance.of_several(rows_of(signatures, rows.first, rows.size()),
                        rows_of(signatures, columns.first, columns.size()), static_cast<std::size_t>(signatures.cols()),
                        {tile.data(), static_cast<std::size_t>(tile.size())});
    return tile;
  }
  for (Eigen::Index i = rows.first; i < rows.last; ++i) {
    for (Eigen::Index j = columns.first; j < columns.last; ++j) {
      // Both of a pair from one call: where compilers contract, (a, b) and (b, a) may differ in the last bit.
      tile(i - rows.first, j - columns.first) =
          i == j ? 0
                 : distance.function(rows_of(signatures, std::min(i, j), 1), rows_of(signatures, std::max(i, j), 1));
    }
  }
  return tile;
}

}  // namespace

std::vector<std::string> distance_names() {
  std::vector<std::string> names;
  for (const NamedDistance& distance : distances()) names.push_back(distance.name);
  return names;
}

DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance) {
  const NamedDistance between = distance_of(distance);
  check_signatures(signatures, between);
  const Tiles all{{0, signatures.rows()}, tile_size(signatures)};
  DistanceMatrix matrix(signatures.rows(), signatures.rows());
  const tbb::blocked_range2d<Eigen::Index> tiles(0, all.count(), 0, all.count());
  // Each pair is computed by whichever thread has its tile, and by itself: threads cannot change a bit.
  tbb::parallel_for(tiles, [&](const tbb::blocked_range2d<Eigen::Index>& some) {
    for (Eigen::Index i = some.rows().begin(); i < some.rows().end(); ++i) {
      for (Eigen::Index j = std::max(i, some.cols().begin()); j < some.cols().end(); ++j) {
        const Stretch rows = all.at(i);
        const Stretch columns = all.at(j);
        const DistanceMatrix tile = tile_distances(between, signatures, rows, columns);
        matrix.block(rows.first, columns.first, rows.size(), columns.size()) = tile;
        matrix.block(columns.first, rows.first, columns.size(), rows.size()) = tile.transpose();
      }
    }
  });
  matrix.diagonal().setZero();
  return matrix;
}

DistanceMatrix distance_rows(const Signatures& signatures, Eigen::Index first, Eigen::Index count,
                             const std::string& distance) {
  const NamedDistance between = distance_of(distance);
  if (first < 0 || count < 0 || first > signatures.rows() - count) {
    throw std::invalid_argument("there are no rows " + std::to_string(first) + " to " + std::to_string(first + count) +
                                " in a distance matrix of " + std::to_string(signatures.rows()));
  }
  check_signatures(signatures, between);
  const Tiles rows{{first, first + count}, tile_size(signatures)};
  const Tiles all{{0, signatures.rows()}, tile_size(signatures)};
  DistanceMatrix distances(count, signatures.rows());
  const tbb::blocked_range2d<Eigen::Index> tiles(0, rows.count(), 0, all.count());
  tbb::parallel_for(tiles, [&](const tbb::blocked_range2d<Eigen::Index>& some) {
    for (Eigen::Index i = some.rows().begin(); i < some.rows().end(); ++i) {
      for (Eigen::Index j = some.cols().begin(); j < some.cols().end(); ++j) {
        const Stretch of = rows.at(i);
        const Stretch to = all.at(j);
        distances.block(of.first - first, to.first, of.size(), to.size()) = tile_distances(between, signatures, of, to);
      }
    }
  });
  for (Eigen::Index row = 0; row < count; ++row) distances(row, first + row) = 0;
  return distances;
}

}  // namespace shapegauge
