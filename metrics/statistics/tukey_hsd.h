#pragma once

#include <Eigen/Core>

#include "shapegauge/metrics/statistics/units.h"

namespace shapegauge {

/// Randomised Tukey HSD ("honestly significant differences"): p-values of all pairs of methods at once, methods x
/// methods, 1 on the diagonal. In each of B resamples the methods' values are shuffled within every unit, and the
/// largest difference of any two averages is kept; the p-value of a pair is (1 + #) / (B + 1), where # counts those
/// that are at least as large as the pair's own difference. No further correction is needed. Carterette, "Multiple
/// testing in statistical analysis of systems-based information retrieval experiments", ACM TOIS 30, 2012. Throws
/// std::invalid_argument where there are no resamples or no units.
Eigen::MatrixXd tukey_hsd_p_values(const Units& units, const ResamplingOptions& options = {});

}  // namespace shapegauge
