#include "shapegauge/metrics/matrix_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <tbb/parallel_for.h>

namespace shapegauge {
namespace {

/// Takes one more number into two hashes.
void mix(std::pair<std::uint64_t, std::uint64_t>& hash, double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  hash.first = (hash.first ^ bits) * 0x9e3779b97f4a7c15ULL;
  hash.first ^= hash.first >> 29U;
  hash.second = (hash.second ^ bits) * 0xd6e8feb86659fd93ULL;
  hash.second ^= hash.second >> 32U;
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

MatrixChecks::RowFindings MatrixChecks::check_row(const DistanceTable& rows, Eigen::Index row, Eigen::Index diagonal) {
  RowFindings found;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (Eigen::Index column = 0; column < rows.cols(); ++column) {
    const double distance = rows(row, column) + 0.0;  // -0 becomes 0
    mix(found.hash, distance);
    if (column == diagonal) continue;
    if (std::isinf(distance)) ++found.infinite;
    if (distance < 0) ++found.negative;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  const bool has_diagonal = diagonal >= 0;
  found.constant = rows.cols() > (has_diagonal ? 2 : 1) && least == most;
  if (!has_diagonal) return found;
  const double own = rows(row, diagonal);
  found.nonzero_diagonal = own != 0;
  found.nearest_to_others = own >= most && own > least;
  return found;
}

void MatrixChecks::add(const DistanceTable& rows) {
  const std::size_t before = rows_.size();
  rows_.resize(before + static_cast<std::size_t>(rows.rows()));
  tbb::parallel_for(before, rows_.size(), [&](std::size_t i) {
    const auto row = static_cast<Eigen::Index>(i - before);
    rows_[i] = check_row(rows, row, square_ ? static_cast<Eigen::Index>(i) : -1);
  });
}

void MatrixChecks::add_equal_rows(MatrixFindings& findings) const {
  std::map<std::pair<std::uint64_t, std::uint64_t>, Eigen::Index> first_of_hash;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto [first, is_new] = first_of_hash.emplace(rows_[i].hash, row);
    if (!is_new) findings.equal_rows.emplace_back(row, first->second);
  }
}

MatrixFindings MatrixChecks::findings() const {
  MatrixFindings findings;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    findings.infinite += rows_[row].infinite;
    findings.negative += rows_[row].negative;
    if (rows_[row].constant) findings.constant_rows.push_back(static_cast<Eigen::Index>(row));
    if (rows_[row].nonzero_diagonal) ++findings.nonzero_diagonal;
    if (rows_[row].nearest_to_others) ++findings.rows_nearest_to_others;
  }
  add_equal_rows(findings);
  return findings;
}

MatrixFindings check_matrix(const DistanceTable& distances, bool square) {
  MatrixChecks checks(square);
  checks.add(distances);
  MatrixFindings findings = checks.findings();
  if (square) add_asymmetry(distances, findings);
  return findings;
}

}  // namespace shapegauge
