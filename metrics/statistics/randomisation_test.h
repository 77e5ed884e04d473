#pragma once

#include <Eigen/Core>

#include "shapegauge/metrics/statistics/units.h"

namespace shapegauge {

/// Paired randomisation (permutation) test, two-sided: if two methods were equally good, which of them is called which
/// would be a matter of chance in each unit. The p-value is (1 + #) / (B + 1), where # counts those of B random
/// exchanges whose difference of averages is at least as far from 0 as the observed one; it is never 0. `differences`
/// and `weights` are by unit. Fisher, "The design of experiments", 1935; for retrieval: Smucker, Allan, Carterette,
/// CIKM 2007. Throws std::invalid_argument where there are no resamples or no units.
double randomisation_p_value(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights,
                             const ResamplingOptions& options = {});

}  // namespace shapegauge
