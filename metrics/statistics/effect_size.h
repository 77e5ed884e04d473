#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Cohen's d for paired differences (d_z): their mean over their standard deviation, that of a sample. About 0.2 is
/// called small, 0.5 medium, 0.8 large. 0 where all differences are 0, infinite where they are equal and not 0. Cohen,
/// "Statistical power analysis for the behavioral sciences", 1988, section 2.3. Unlike a p-value it does not grow with
/// the number of queries. Throws std::invalid_argument where there are fewer than two.
double effect_size(const Eigen::VectorXd& differences);

}  // namespace shapegauge
