#include "shapegauge/retrieval/gaussian_smoothing.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace shapegauge {
namespace {

constexpr double kernel_reach = 4.0;  // in standard deviations

// Weights for offsets 0, 1, ... reach; the kernel is symmetric, and its two halves together sum to 1.
Eigen::VectorXd half_kernel(double standard_deviation) {
  const auto reach = static_cast<Eigen::Index>(std::lround(kernel_reach * standard_deviation));
  Eigen::VectorXd weights(reach + 1);
  double total = 0;
  for (Eigen::Index offset = 0; offset <= reach; ++offset) {
    const double x = static_cast<double>(offset) / standard_deviation;
    weights[offset] = std::exp(-0.5 * x * x);
    total += offset == 0 ? weights[offset] : 2 * weights[offset];
  }
  return weights / total;
}

// The bin that the mirrored continuation of a histogram of that many bins shows at a position.
Eigen::Index mirrored_bin(Eigen::Index position, Eigen::Index bins) {
  const Eigen::Index period = 2 * bins;
  const Eigen::Index phase = ((position % period) + period) % period;
  return phase < bins ? phase : period - 1 - phase;
}

}  // namespace

Eigen::VectorXd smooth_gaussian(const Eigen::VectorXd& histogram, double standard_deviation) {
  const Eigen::Index bins = histogram.size();
  if (bins == 0) throw std::invalid_argument("a histogram without bins cannot be smoothed");
  if (!(standard_deviation >= 0 && standard_deviation <= static_cast<double>(bins))) {
    throw std::invalid_argument("the smoothing of a histogram must lie between 0 and its number of bins (" +
                                std::to_string(bins) + "), not " + std::to_string(standard_deviation));
  }
  if (standard_deviation == 0) return histogram;
  const Eigen::VectorXd kernel = half_kernel(standard_deviation);
  Eigen::VectorXd smoothed(bins);
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    double sum = kernel[0] * histogram[bin];
    for (Eigen::Index offset = 1; offset < kernel.size(); ++offset) {
      sum +=
          kernel[offset] * (histogram[mirrored_bin(bin - offset, bins)] + histogram[mirrored_bin(bin + offset, bins)]);
    }
    smoothed[bin] = sum;
  }
  return smoothed;
}

}  // namespace shapegauge
