#include "shapegauge/retrieval/positive_definite_inverse.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

namespace {

/// Replaces the lower triangle by that of the Cholesky factor, in the blocks and steps of Eigen's LLT. Can be
/// interrupted between blocks.
void factorise(Eigen::MatrixXd& matrix) {
  using Steps = Eigen::internal::llt_inplace<double, Eigen::Lower>;
  const Eigen::Index size = matrix.rows();
  if (size < 32) {
    Steps::unblocked(matrix);
    return;
  }
  const Eigen::Index block = std::clamp<Eigen::Index>(size / 8 / 16 * 16, 8, 128);
  for (Eigen::Index k = 0; k < size; k += block) {
    check_interruption();
    const Eigen::Index width = std::min(block, size - k);
    const Eigen::Index rest = size - k - width;
    auto corner = matrix.block(k, k, width, width);
    if (Steps::unblocked(corner) >= 0 || rest == 0) return;
    auto below = matrix.block(k + width, k, rest, width);
    corner.adjoint().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(below);
    matrix.block(k + width, k + width, rest, rest).selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
  }
}

}  // namespace

Eigen::MatrixXd positive_definite_inverse(Eigen::MatrixXd matrix) {
  // A multiple of the columns that Eigen's kernels take together, so that each is computed as in the whole.
  constexpr Eigen::Index columns_at_once = 64;
  const Eigen::Index size = matrix.rows();
  factorise(matrix);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(size, size);
  parallel_for(Eigen::Index{0}, (size + columns_at_once - 1) / columns_at_once, [&](Eigen::Index part) {
    const Eigen::Index first = part * columns_at_once;
    auto columns = inverse.middleCols(first, std::min(columns_at_once, size - first));
    matrix.triangularView<Eigen::Lower>().solveInPlace(columns);
    matrix.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  });
  return inverse;
}

}  // namespace shapegauge
