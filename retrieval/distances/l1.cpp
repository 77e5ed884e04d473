// The sum over a signature's entries, compiled once for each instruction set that Highway knows of.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/retrieval/distances/l1.cpp"
#include "shapegauge/retrieval/distances/l1.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Eight sums, of the entries i with the same i % 8, whatever the width of a vector: the same bits on every machine.
constexpr std::size_t sums = 8;
using D = hn::CappedTag<double, sums>;
constexpr std::size_t lanes = hn::MaxLanes(D());
using Sums = std::array<hn::Vec<D>, sums / lanes>;

double total(const Sums& sum, const double* a, const float* b, std::size_t first, std::size_t size) {
  alignas(64) std::array<double, sums> parts;
  for (std::size_t v = 0; v < sum.size(); ++v) hn::Store(sum[v], D(), parts.data() + v * lanes);
  for (std::size_t i = first; i < size; ++i) parts[i % sums] += std::abs(a[i] - static_cast<double>(b[i]));
  return ((parts[0] + parts[4]) + (parts[1] + parts[5])) + ((parts[2] + parts[6]) + (parts[3] + parts[7]));
}

/// Distances from one signature to `rows` others that follow each other in memory: together, so that no addition has to
/// wait for the one before, and each entry of the first is loaded once.
template <std::size_t rows>
void l1_to_rows(const double* a, const float* b, std::size_t size, double* distances) {
  const hn::Rebind<float, D> single;
  std::array<Sums, rows> sum;
  for (Sums& one : sum) one.fill(hn::Zero(D()));
  std::size_t i = 0;
  for (; i + sums <= size; i += sums) {
    for (std::size_t v = 0; v < sums / lanes; ++v) {
      const auto left = hn::LoadU(D(), a + i + v * lanes);
      for (std::size_t row = 0; row < rows; ++row) {
        const auto right = hn::PromoteTo(D(), hn::LoadU(single, b + row * size + i + v * lanes));
        sum[row][v] = hn::Add(sum[row][v], hn::Abs(hn::Sub(left, right)));
      }
    }
  }
  for (std::size_t row = 0; row < rows; ++row) distances[row] = total(sum[row], a, b + row * size, i, size);
}

void l1(const float* a, const float* b, std::size_t size, std::size_t count, double* distances) {
  constexpr std::size_t together = 4;
  const std::vector<double> promoted(a, a + size);
  std::size_t row = 0;
  for (; row + together <= count; row += together) {
    l1_to_rows<together>(promoted.data(), b + row * size, size, distances + row);
  }
  for (; row < count; ++row) l1_to_rows<1>(promoted.data(), b + row * size, size, distances + row);
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(l1);

void l1_distances(std::span<const float> a, std::span<const float> others, std::span<double> distances) {
  HWY_DYNAMIC_DISPATCH(l1)(a.data(), others.data(), a.size(), distances.size(), distances.data());
}

double l1_distance(std::span<const float> a, std::span<const float> b) {
  double distance = 0;
  l1_distances(a, b, {&distance, 1});
  return distance;
}

}  // namespace shapegauge
#endif  // HWY_ONCE
