// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/distances.h"

#include <algorithm>
#include <cmath>

#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

// In all of them the spans are of equal length.

// The sum of the entries, in double precision from the first to the last.
double histogram_sum(std::span<const float> histogram) {
  double sum = 0;
  for (const float entry : histogram) sum += static_cast<double>(entry);
  return sum;
}

// Chi-square distance: half the sum of (a[i] - b[i])^2 / (a[i] + b[i]), where both are 0 nothing. Between 0 and 1 for
// histograms that sum to 1. Entries may not be negative. Puzicha, Hofmann, Buhmann, "Non-parametric similarity
// measures for unsupervised texture segmentation and image retrieval", CVPR 1997. The spans are of equal length.
double chi2_distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double total = static_cast<double>(a[i]) + static_cast<double>(b[i]);
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    if (total > 0) sum += difference * difference / total;
  }
  return sum / 2;
}

double length_of(std::span<const float> vector) {
  double sum = 0;
  for (const float entry : vector) sum += static_cast<double>(entry) * static_cast<double>(entry);
  return std::sqrt(sum);
}

// 1 - the cosine of the angle between two vectors, from 0 (same direction) to 2. Computed as half of the squared
// distance of the unit vectors, which is the same and has no cancellation for nearly parallel ones. Neither vector may
// be zero. The spans are of equal length.
double cosine_distance(std::span<const float> a, std::span<const float> b) {
  const double length_a = length_of(a);
  const double length_b = length_of(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) / length_a - static_cast<double>(b[i]) / length_b;
    sum += difference * difference;
  }
  return sum / 2;
}

// Earth mover's distance of two histograms over a line, each first divided by its sum: the sum of the magnitudes of
// the differences of their cumulative sums, that is, the minimum work of moving one into the other, in bins. Entries
// may not be negative nor all be 0. Rubner, Tomasi, Guibas, "The earth mover's distance as a metric for image
// retrieval", IJCV 40, 2000. The order of the entries matters: it suits one histogram, not a concatenation of several.
// The spans are of equal length.
double earth_movers_distance(std::span<const float> a, std::span<const float> b) {
  const double sum_a = histogram_sum(a);
  const double sum_b = histogram_sum(b);
  double to_move = 0;
  double work = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    to_move += static_cast<double>(a[i]) / sum_a - static_cast<double>(b[i]) / sum_b;
    work += std::abs(to_move);
  }
  return work;
}

// Hellinger distance of two histograms, each first divided by its sum: the L2 distance of the square roots of their
// entries, divided by the square root of 2; between 0 and 1. Entries may not be negative nor all be 0. The spans are
// of equal length.
double hellinger_distance(std::span<const float> a, std::span<const float> b) {
  const double sum_a = histogram_sum(a);
  const double sum_b = histogram_sum(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference =
        std::sqrt(static_cast<double>(a[i]) / sum_a) - std::sqrt(static_cast<double>(b[i]) / sum_b);
    sum += difference * difference;
  }
  return std::sqrt(sum / 2);
}

double divergence(double p, double mean) { return p > 0 ? p * std::log2(p / mean) : 0.0; }

// Jensen-Shannon distance of two histograms, each first divided by its sum: the square root of the mean of the
// Kullback-Leibler divergences from each to the mean of both, in bits; a metric, between 0 and 1. Entries may not be
// negative nor all be 0. Endres and Schindelin, "A new metric for probability distributions", IEEE Transactions on
// Information Theory 49, 2003. The spans are of equal length.
double jensen_shannon_distance(std::span<const float> a, std::span<const float> b) {
  const double sum_a = histogram_sum(a);
  const double sum_b = histogram_sum(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double p = static_cast<double>(a[i]) / sum_a;
    const double q = static_cast<double>(b[i]) / sum_b;
    const double mean = (p + q) / 2;
    sum += divergence(p, mean) + divergence(q, mean);
  }
  return std::sqrt(std::max(0.0, sum / 2));  // rounding may leave a little less than nothing
}

// Returns the library's distances, in the order of listings.
std::vector<NamedDistance> builtin_distances() {
  return {
      {"l1", l1_distance, DistanceDomain::any, l1_distances, "sum of absolute differences"},
      {"l2", l2_distance, DistanceDomain::any, nullptr, "Euclidean"},
      {"cosine", cosine_distance, DistanceDomain::not_zero, nullptr, "1 - cosine of the angle"},
      {"chi2", chi2_distance, DistanceDomain::not_negative, nullptr, "half the sum of (a - b)² / (a + b)"},
      {"hellinger", hellinger_distance, DistanceDomain::histograms, nullptr,
       "l2 distance of the square roots, divided by √2"},
      {"jensen-shannon", jensen_shannon_distance, DistanceDomain::histograms, nullptr,
       "square root of the Jensen-Shannon divergence in bits"},
      {"emd", earth_movers_distance, DistanceDomain::histograms, nullptr, "earth mover's distance in bins"},
  };
}

}  // namespace

// L2 (Euclidean) distance: the square root of the sum of (a[i] - b[i])^2, in double precision. The spans are of equal
// length.
double l2_distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

Registry<NamedDistance>& distances() {
  static Registry<NamedDistance> all("distance", builtin_distances(), has_functions<&NamedDistance::function>);
  return all;
}

}  // namespace shapegauge
