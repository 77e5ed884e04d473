// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/matrix_checks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/parallel_parts.h"

namespace shapegauge {
namespace {

// Combines a number into two hashes.
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
  Eigen::Index infinite = 0;
  Eigen::Index one_sided = 0;
  double largest = 0;

  Asymmetry operator+(const Asymmetry& other) const {
    return {.pairs = pairs + other.pairs,
            .infinite = infinite + other.infinite,
            .one_sided = one_sided + other.one_sided,
            .largest = std::max(largest, other.largest)};
  }
};

constexpr Eigen::Index tile = 64;  // columns that are compared with their mirror images in the cache

// Compares the entries of some columns right of the diagonal with their mirror images. The diagonal's first entry is
// rows(0, first).
Asymmetry asymmetry_of_columns(const DistanceTable& rows, Eigen::Index first, const DistanceTable& mirrored,
                               const tbb::blocked_range<Eigen::Index>& columns) {
  Asymmetry found;
  for (Eigen::Index column = columns.begin(); column < columns.end(); ++column) {
    for (Eigen::Index row = 0; row < std::min(column, rows.rows()); ++row) {
      const double entry = rows(row, first + column);
      const double mirror = mirrored(column, row);
      if (entry == mirror) continue;
      ++found.pairs;
      if (entry == 0 || mirror == 0) ++found.one_sided;
      const double difference = std::abs(entry - mirror);
      if (std::isfinite(difference)) {
        found.largest = std::max(found.largest, difference);
      } else {
        ++found.infinite;
      }
    }
  }
  return found;
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
    if (std::isinf(distance)) {
      ++found.infinite;
    } else {
      found.largest = std::max(found.largest, std::abs(distance));
    }
    if (distance < 0) ++found.negative;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  const bool has_diagonal = diagonal >= 0;
  found.unreachable = most > -least && least == std::numeric_limits<double>::infinity();
  found.constant = !found.unreachable && rows.cols() > (has_diagonal ? 2 : 1) && least == most;
  found.at_zero = least == 0 && most > 0;
  if (!has_diagonal) return found;
  const double diagonal_distance = rows(row, diagonal);
  if (std::isinf(diagonal_distance)) return found;  // excludes the model from its own list
  found.nonzero_diagonal = diagonal_distance != 0;
  found.nearest_to_others = diagonal_distance >= most && diagonal_distance > least;
  return found;
}

void MatrixChecks::add(const DistanceTable& rows) {
  const std::size_t before = rows_.size();
  rows_.resize(before + static_cast<std::size_t>(rows.rows()));
  parallel_for(before, rows_.size(), [&](std::size_t i) {
    const auto row = static_cast<Eigen::Index>(i - before);
    rows_[i] = check_row(rows, row, square_ ? static_cast<Eigen::Index>(i) : -1);
  });
}

void MatrixChecks::compare(const DistanceTable& rows, Eigen::Index first, const DistanceTable& mirrored) {
  const Asymmetry found = interruptible_parallel_reduce(
      tbb::blocked_range<Eigen::Index>(0, mirrored.rows(), tile), Asymmetry{},
      [&](const tbb::blocked_range<Eigen::Index>& columns, const Asymmetry& before) {
        return before + asymmetry_of_columns(rows, first, mirrored, columns);
      },
      std::plus<>());
  asymmetric_pairs_ += found.pairs;
  infinite_asymmetries_ += found.infinite;
  one_sided_pairs_ += found.one_sided;
  largest_asymmetry_ = std::max(largest_asymmetry_, found.largest);
}

void MatrixChecks::add_asymmetry(MatrixFindings& findings) const {
  constexpr double rounding = 1e-12;
  double largest = 0;
  for (const RowFindings& row : rows_) largest = std::max(largest, row.largest);
  if (infinite_asymmetries_ == 0 && largest_asymmetry_ <= rounding * largest) return;
  findings.asymmetric_pairs = asymmetric_pairs_;
  findings.largest_asymmetry = largest_asymmetry_;
  const auto size = static_cast<Eigen::Index>(rows_.size());
  findings.triangular = one_sided_pairs_ == asymmetric_pairs_ && 4 * asymmetric_pairs_ > size * (size - 1);
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
  findings.square = square_;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!rows_[row].unreachable) findings.infinite += rows_[row].infinite;
    findings.negative += rows_[row].negative;
    if (rows_[row].constant) findings.constant_rows.push_back(static_cast<Eigen::Index>(row));
    if (rows_[row].unreachable) findings.infinite_rows.push_back(static_cast<Eigen::Index>(row));
    if (rows_[row].nonzero_diagonal) ++findings.nonzero_diagonal;
    if (rows_[row].nearest_to_others) ++findings.rows_nearest_to_others;
    if (rows_[row].at_zero) ++findings.rows_at_zero;
  }
  add_asymmetry(findings);
  add_equal_rows(findings);
  return findings;
}

}  // namespace shapegauge
