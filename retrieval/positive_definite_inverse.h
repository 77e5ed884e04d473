#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Inverts a symmetric positive definite matrix by its Cholesky factorisation, in parallel where possible. The result
/// has the same bits as Eigen's matrix.llt().solve(identity), on any number of threads. Throws Interrupted.
Eigen::MatrixXd positive_definite_inverse(Eigen::MatrixXd matrix);

}  // namespace shapegauge
