#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// The answer of a paired t-test.
struct PairedT {
  double t = 0;  ///< infinite where all differences are equal and not 0
  int degrees_of_freedom = 0;
  double p = 1;  ///< two-sided; 1 where all differences are 0
};

/// Student's t-test of the mean of paired differences against 0, two-sided. "Student", Biometrika 6, 1908. It takes the
/// differences as independent, and their mean as normally distributed, which for values between 0 and 1 with many equal
/// ones holds from some dozens on. Throws std::invalid_argument where there are fewer than two.
PairedT paired_t_test(const Eigen::VectorXd& differences);

}  // namespace shapegauge
