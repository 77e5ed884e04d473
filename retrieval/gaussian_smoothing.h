#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// The histogram convolved with a Gaussian whose standard deviation is given in bins: the kernel is sampled at whole
/// bins up to four standard deviations and normalised to sum 1. At both ends the histogram is continued by its mirror
/// image (c b a | a b c | c b a), so no mass is lost, the sum stays what it was, and a uniform histogram stays uniform.
/// That is the convention of scipy.ndimage.gaussian_filter1d with mode "reflect". Throws std::invalid_argument for an
/// empty histogram and for a standard deviation that is not between 0 (no smoothing) and the number of bins.
Eigen::VectorXd smooth_gaussian(const Eigen::VectorXd& histogram, double standard_deviation);

}  // namespace shapegauge
