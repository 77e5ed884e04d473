#include "shapegauge/metrics/tied_hits.h"

#include <algorithm>

namespace shapegauge {
namespace {

constexpr double negligible = 1e-18;  // of the largest term: less than the rounding of the sum

// The mean of 1 / (ranks_before + t) for the place t of the j-th of `hits` hits among `size` places. Probabilities are
// taken relative to that of the likeliest place, from which they fall to both sides, so that nothing under- or
// overflows whatever the sizes are.
double mean_reciprocal_rank(std::size_t size, std::size_t hits, std::size_t j, std::size_t ranks_before) {
  const std::size_t first = j;
  const std::size_t last = size - hits + j;
  const std::size_t likeliest = hits == 1 ? first : std::clamp(1 + (j - 1) * size / (hits - 1), first, last);
  // P(t + 1) / P(t)
  const auto ratio = [&](std::size_t t) {
    return static_cast<double>(t) * static_cast<double>(last - t) /
           (static_cast<double>(t - j + 1) * static_cast<double>(size - t));
  };
  double total = 1;
  double sum = 1 / static_cast<double>(ranks_before + likeliest);
  double probability = 1;
  for (std::size_t t = likeliest; t < last && probability > negligible; ++t) {
    probability *= ratio(t);
    total += probability;
    sum += probability / static_cast<double>(ranks_before + t + 1);
  }
  probability = 1;
  for (std::size_t t = likeliest; t > first && probability > negligible; --t) {
    probability /= ratio(t - 1);
    total += probability;
    sum += probability / static_cast<double>(ranks_before + t - 1);
  }
  return sum / total;
}

}  // namespace

void append_precisions(std::vector<double>& precisions, std::size_t size, std::size_t hits, std::size_t ranks_before) {
  const std::size_t hits_before = precisions.size();
  for (std::size_t j = 1; j <= hits; ++j) {
    const auto k = static_cast<double>(hits_before + j);
    precisions.push_back(hits == size ? k / static_cast<double>(ranks_before + j)
                                      : k * mean_reciprocal_rank(size, hits, j, ranks_before));
  }
}

}  // namespace shapegauge
