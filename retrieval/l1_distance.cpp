// SPDX-License-Identifier: GPL-3.0-or-later
// The sum over a signature's entries, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/retrieval/l1_distance.cpp"
#include "shapegauge/retrieval/l1_distance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <hwy/aligned_allocator.h>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Eight sums, of the entries i with the same i % 8, whatever the vector width: the same bits on every machine.
constexpr std::size_t sums = 8;
using D = hn::CappedTag<double, sums>;
constexpr std::size_t lanes = hn::MaxLanes(D());

/// Signatures in double precision, padded with zeros to a multiple of eight entries.
struct Promoted {
  hwy::AlignedFreeUniquePtr<double[]> entries;
  std::size_t stride;  ///< entries from one signature to the next
  std::size_t count;

  [[nodiscard]] const double* row(std::size_t i) const { return entries.get() + i * stride; }
};

Promoted promoted(std::span<const float> signatures, std::size_t size) {
  const hn::Rebind<float, D> single;
  const std::size_t stride = (size + sums - 1) / sums * sums;
  const std::size_t count = signatures.size() / size;
  Promoted result{hwy::AllocateAligned<double>(stride * count), stride, count};
  for (std::size_t row = 0; row < count; ++row) {
    const float* from = signatures.data() + row * size;
    double* to = result.entries.get() + row * stride;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) hn::Store(hn::PromoteTo(D(), hn::LoadU(single, from + i)), D(), to + i);
    for (; i < stride; ++i) to[i] = i < size ? from[i] : 0;
  }
  return result;
}

double total(const std::array<double, sums>& parts) {
  return ((parts[0] + parts[4]) + (parts[1] + parts[5])) + ((parts[2] + parts[6]) + (parts[3] + parts[7]));
}

/// Computes distances of `rows` signatures from `i` on to `columns` others from `j` on. Processing them together hides
/// the latency of additions and reuses loaded entries.
template <std::size_t rows, std::size_t columns>
void l1_block(const Promoted& some, std::size_t i, const Promoted& others, std::size_t j, double* distances) {
  const auto one = hn::Set(D(), 1.0);
  alignas(64) std::array<std::array<std::array<double, sums>, columns>, rows> parts;
  for (std::size_t part = 0; part < sums; part += lanes) {
    std::array<std::array<hn::Vec<D>, columns>, rows> sum;
    for (auto& row : sum) row.fill(hn::Zero(D()));
    for (std::size_t entry = part; entry < some.stride; entry += sums) {
      std::array<hn::Vec<D>, rows> left;
      for (std::size_t row = 0; row < rows; ++row) left[row] = hn::Load(D(), some.row(i + row) + entry);
      for (std::size_t column = 0; column < columns; ++column) {
        const auto right = hn::Load(D(), others.row(j + column) + entry);
        for (std::size_t row = 0; row < rows; ++row) {
          // With fused multiply-subtract this equals a - b to the bit, on otherwise idle units.
          const auto difference = hn::MulSub(left[row], one, right);
          sum[row][column] = hn::Add(sum[row][column], hn::Abs(difference));
        }
      }
    }
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        hn::Store(sum[row][column], D(), parts[row][column].data() + part);
      }
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      distances[row * others.count + column] = total(parts[row][column]);
    }
  }
}

template <std::size_t columns>
void l1_columns(const Promoted& some, const Promoted& others, std::size_t j, double* distances) {
  constexpr std::size_t together = 2;
  std::size_t i = 0;
  for (; i + together <= some.count; i += together) {
    l1_block<together, columns>(some, i, others, j, distances + i * others.count + j);
  }
  for (; i < some.count; ++i) l1_block<1, columns>(some, i, others, j, distances + i * others.count + j);
}

void l1(std::span<const float> some, std::span<const float> others, std::size_t size, double* distances) {
  constexpr std::size_t together = 4;
  const Promoted left = promoted(some, size);
  const Promoted right = promoted(others, size);
  std::size_t j = 0;
  for (; j + together <= right.count; j += together) l1_columns<together>(left, right, j, distances);
  for (; j < right.count; ++j) l1_columns<1>(left, right, j, distances);
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(l1);

void l1_distances(std::span<const float> some, std::span<const float> others, std::size_t size,
                  std::span<double> distances) {
  if (size == 0) {
    std::ranges::fill(distances, 0);
    return;
  }
  HWY_DYNAMIC_DISPATCH(l1)(some, others, size, distances.data());
}

double l1_distance(std::span<const float> a, std::span<const float> b) {
  double distance = 0;
  l1_distances(a, b, a.size(), {&distance, 1});
  return distance;
}

}  // namespace shapegauge
#endif  // HWY_ONCE
