#include "shapegauge/core/fields/dominant_eigenvalues.h"

#include <Eigen/Eigenvalues>
#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>
#include <algorithm>
#include <functional>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

namespace {

Eigen::VectorXd descending_sizes(const Eigen::VectorXd& eigenvalues, Eigen::Index count) {
  Eigen::VectorXd sizes = eigenvalues.cwiseAbs();
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes.head(std::min(count, sizes.size()));
}

}  // namespace

Eigen::VectorXd dominant_eigenvalues(const Eigen::MatrixXd& matrix, Eigen::Index count) {
  check_interruption();
  const Eigen::Index basis = 3 * count;
  if (matrix.rows() <= 2 * basis) {  // faster directly
    return descending_sizes(
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues(), count);
  }
  Spectra::DenseSymMatProd<double> product(matrix);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, count, basis);
  solver.init();
  constexpr Eigen::Index most_iterations = 300;
  constexpr double tolerance = 1e-8;
  solver.compute(Spectra::SortRule::LargestMagn, most_iterations, tolerance);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw InputError("the largest eigenvalues of a matrix of distances did not converge");
  }
  return descending_sizes(solver.eigenvalues(), count);
}

}  // namespace shapegauge
