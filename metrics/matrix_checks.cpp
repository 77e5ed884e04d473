#include "shapegauge/metrics/matrix_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tbb/parallel_for.h>
#include <unordered_map>

namespace shapegauge {
namespace {

struct RowFindings {
  Eigen::Index infinite = 0;
  Eigen::Index negative = 0;
  bool constant = false;
  bool nonzero_diagonal = false;
  bool nearest_to_others = false;
  std::uint64_t hash = 0;
};

RowFindings check_row(const DistanceTable& distances, Eigen::Index row, bool square) {
  RowFindings found;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    const double distance = distances(row, column) + 0.0;  // -0 becomes 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &distance, sizeof bits);
    found.hash = (found.hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    found.hash ^= found.hash >> 29U;
    if (square && column == row) continue;
    if (std::isinf(distance)) ++found.infinite;
    if (distance < 0) ++found.negative;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  const bool others = distances.cols() > (square ? 2 : 1);
  found.constant = others && least == most;
  if (!square) return found;
  const double own = distances(row, row);
  found.nonzero_diagonal = own != 0;
  found.nearest_to_others = own >= most && own > least;
  return found;
}

std::vector<std::pair<Eigen::Index, Eigen::Index>> equal_rows(const DistanceTable& distances,
                                                              const std::vector<RowFindings>& rows) {
  std::unordered_map<std::uint64_t, std::vector<Eigen::Index>> rows_of_hash;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> equal;
  for (Eigen::Index row = 0; row < distances.rows(); ++row) {
    std::vector<Eigen::Index>& earlier = rows_of_hash[rows[static_cast<std::size_t>(row)].hash];
    const auto same =
        std::ranges::find_if(earlier, [&](Eigen::Index other) { return distances.row(other) == distances.row(row); });
    if (same != earlier.end()) {
      equal.emplace_back(row, *same);
    } else {
      earlier.push_back(row);
    }
  }
  return equal;
}

struct Asymmetry {
  Eigen::Index pairs = 0;
  double largest = 0;
};

constexpr Eigen::Index tile = 64;  // rows and columns of a square that is compared with its mirror image in the cache

// The entries above the diagonal in so many rows from `first` on, against those below it.
Asymmetry asymmetry_of_rows(const DistanceTable& distances, Eigen::Index first) {
  Asymmetry found;
  const Eigen::Index last = std::min(first + tile, distances.rows());
  for (Eigen::Index columns = first; columns < distances.cols(); columns += tile) {
    for (Eigen::Index i = first; i < last; ++i) {
      for (Eigen::Index j = std::max(i + 1, columns); j < std::min(columns + tile, distances.cols()); ++j) {
        if (distances(i, j) == distances(j, i)) continue;
        ++found.pairs;
        const double difference = std::abs(distances(i, j) - distances(j, i));
        if (std::isfinite(difference)) found.largest = std::max(found.largest, difference);
      }
    }
  }
  return found;
}

void add_asymmetry(const DistanceTable& distances, MatrixFindings& findings) {
  std::vector<Asymmetry> of_tiles(static_cast<std::size_t>((distances.rows() + tile - 1) / tile));
  tbb::parallel_for(std::size_t{0}, of_tiles.size(), [&](std::size_t i) {
    of_tiles[i] = asymmetry_of_rows(distances, static_cast<Eigen::Index>(i) * tile);
  });
  for (const Asymmetry& found : of_tiles) {
    findings.asymmetric_pairs += found.pairs;
    findings.largest_asymmetry = std::max(findings.largest_asymmetry, found.largest);
  }
}

}  // namespace

MatrixFindings check_matrix(const DistanceTable& distances, bool square) {
  std::vector<RowFindings> rows(static_cast<std::size_t>(distances.rows()));
  tbb::parallel_for(std::size_t{0}, rows.size(),
                    [&](std::size_t row) { rows[row] = check_row(distances, static_cast<Eigen::Index>(row), square); });
  MatrixFindings findings;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    findings.infinite += rows[row].infinite;
    findings.negative += rows[row].negative;
    if (rows[row].constant) findings.constant_rows.push_back(static_cast<Eigen::Index>(row));
    if (rows[row].nonzero_diagonal) ++findings.nonzero_diagonal;
    if (rows[row].nearest_to_others) ++findings.rows_nearest_to_others;
  }
  findings.equal_rows = equal_rows(distances, rows);
  if (square) add_asymmetry(distances, findings);
  return findings;
}

}  // namespace shapegauge
