#include "shapegauge/core/shape/point_normals.h"

#include <Eigen/Eigenvalues>
#include <tbb/parallel_for.h>

#include "shapegauge/core/shape/point_neighbours.h"

namespace shapegauge {

Points unsigned_point_normals(const Points& points) {
  constexpr Eigen::Index neighbours = 12;
  const PointNeighbours nearest = nearest_neighbours(points, neighbours);
  Points normals = Points::Zero(points.rows(), 3);
  tbb::parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
    // Relative to the farthest neighbour, so that products neither overflow nor vanish.
    const Eigen::Index count = nearest.indices.cols();
    const double reach = count > 0 ? nearest.distances(i, count - 1) : 0;
    if (!(reach > 0)) return;
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, neighbours + 1, 3> around(count + 1, 3);
    around.row(count).setZero();
    for (Eigen::Index k = 0; k < count; ++k) {
      around.row(k) = (points.row(nearest.indices(i, k)) - points.row(i)) / reach;
    }
    around.rowwise() -= around.colwise().mean().eval();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(around.transpose() * around);
    normals.row(i) = solver.eigenvectors().col(0).transpose();
  });
  return normals;
}

}  // namespace shapegauge
