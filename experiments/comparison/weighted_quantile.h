#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// The least of the values such that those up to it have at least this share of the whole weight: 0.5 for a median,
/// which is then always one of the values. NaN where there are no values or no weight. Throws std::invalid_argument
/// where values and weights differ in number.
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double share);

}  // namespace shapegauge
