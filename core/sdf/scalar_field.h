#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// One value per sample with the area that the sample stands for. A value that could not be found is NaN, and whoever
/// computes or uses a field says how many there are.
struct ScalarField {
  Eigen::VectorXd values;
  Eigen::VectorXd weights;
};

}  // namespace shapegauge
