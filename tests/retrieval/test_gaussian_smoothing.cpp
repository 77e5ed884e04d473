#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <vector>

#include "shapegauge/retrieval/gaussian_smoothing.h"

namespace shapegauge {
namespace {

// The convolution written out the long way: the mirrored histogram is laid out in full, then every offset is summed.
Eigen::VectorXd smoothed_naively(const Eigen::VectorXd& histogram, double standard_deviation) {
  const auto reach = static_cast<int>(4 * standard_deviation + 0.5);
  std::vector<double> once(histogram.begin(), histogram.end());
  std::vector<double> there_and_back = once;
  there_and_back.insert(there_and_back.end(), once.rbegin(), once.rend());
  std::vector<double> unrolled;
  const int copies = reach / static_cast<int>(there_and_back.size()) + 1;
  for (int copy = 0; copy < 2 * copies + 1; ++copy) {
    unrolled.insert(unrolled.end(), there_and_back.begin(), there_and_back.end());
  }
  const int origin = copies * static_cast<int>(there_and_back.size());
  Eigen::VectorXd result = Eigen::VectorXd::Zero(histogram.size());
  double total = 0;
  for (int offset = -reach; offset <= reach; ++offset) {
    const double weight = std::exp(-offset * offset / (2 * standard_deviation * standard_deviation));
    total += weight;
    for (int bin = 0; bin < static_cast<int>(histogram.size()); ++bin) {
      result[bin] += weight * unrolled[static_cast<std::size_t>(origin + bin + offset)];
    }
  }
  return result / total;
}

rc::Gen<Eigen::VectorXd> histograms() {
  return rc::gen::map(rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))),
                      [](const std::vector<int>& counts) {
                        Eigen::VectorXd histogram(static_cast<Eigen::Index>(counts.size()));
                        for (Eigen::Index i = 0; i < histogram.size(); ++i) {
                          histogram[i] = counts[static_cast<std::size_t>(i)];
                        }
                        return histogram;
                      });
}

double deviation_up_to(Eigen::Index bins) {
  return static_cast<double>(*rc::gen::inRange<Eigen::Index>(1, bins * 100 + 1)) / 100.0;
}

TEST(GaussianSmoothing, NoneAtZero) {
  const Eigen::VectorXd histogram = Eigen::VectorXd::LinSpaced(5, 1, 5);
  EXPECT_EQ(smooth_gaussian(histogram, 0), histogram);
}

// At a border the mirror image gives back what would have left: worked out by hand for one unit of mass in bin 0.
TEST(GaussianSmoothing, MassAtABorderIsMirrored) {
  const Eigen::VectorXd histogram = Eigen::VectorXd::Unit(9, 0);
  const Eigen::VectorXd result = smooth_gaussian(histogram, 1);
  const auto g = [](int offset) { return std::exp(-0.5 * offset * offset); };
  const double total = g(0) + 2 * (g(1) + g(2) + g(3) + g(4));
  EXPECT_NEAR(result[0], (g(0) + g(1)) / total, 1e-15);
  EXPECT_NEAR(result[1], (g(1) + g(2)) / total, 1e-15);
  EXPECT_NEAR(result[3], (g(3) + g(4)) / total, 1e-15);
  EXPECT_NEAR(result[4], g(4) / total, 1e-15);
  EXPECT_EQ(result[5], 0);
}

TEST(GaussianSmoothing, RefusesWhatIsOutOfRange) {
  const Eigen::VectorXd histogram = Eigen::VectorXd::Ones(3);
  EXPECT_THROW(smooth_gaussian(Eigen::VectorXd(), 1), std::invalid_argument);
  EXPECT_THROW(smooth_gaussian(histogram, -0.5), std::invalid_argument);
  EXPECT_THROW(smooth_gaussian(histogram, 3.5), std::invalid_argument);
  EXPECT_THROW(smooth_gaussian(histogram, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

RC_GTEST_PROP(GaussianSmoothing, AgreesWithTheSumWrittenOut, ()) {
  const Eigen::VectorXd histogram = *histograms();
  const double deviation = deviation_up_to(histogram.size());
  const Eigen::VectorXd difference = smooth_gaussian(histogram, deviation) - smoothed_naively(histogram, deviation);
  RC_ASSERT(difference.cwiseAbs().maxCoeff() <= 1e-12 * (1 + histogram.sum()));
}

RC_GTEST_PROP(GaussianSmoothing, KeepsTheSumAndTheUniformHistogram, ()) {
  const Eigen::VectorXd histogram = *histograms();
  const double deviation = deviation_up_to(histogram.size());
  const double sum = smooth_gaussian(histogram, deviation).sum();
  RC_ASSERT(std::abs(sum - histogram.sum()) <= 1e-12 * (1 + histogram.sum()));
  const Eigen::VectorXd uniform = Eigen::VectorXd::Ones(histogram.size());
  RC_ASSERT((smooth_gaussian(uniform, deviation) - uniform).cwiseAbs().maxCoeff() <= 1e-12);
}

}  // namespace
}  // namespace shapegauge
