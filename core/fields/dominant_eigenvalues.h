#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// The absolute values of the `count` eigenvalues of a symmetric matrix that are largest in absolute value, in
/// descending order, by Lanczos iteration (Spectra); fewer where the matrix has fewer rows. Throws InputError where the
/// iteration does not converge.
Eigen::VectorXd dominant_eigenvalues(const Eigen::MatrixXd& matrix, Eigen::Index count);

}  // namespace shapegauge
