#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// The inverse of a symmetric positive definite matrix by its Cholesky factorisation. The same bits as Eigen's
/// matrix.llt().solve(identity) for any number of threads, but in parallel where possible, and can be interrupted.
/// Throws Interrupted.
Eigen::MatrixXd positive_definite_inverse(Eigen::MatrixXd matrix);

}  // namespace shapegauge
