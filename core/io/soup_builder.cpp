#include "shapegauge/core/io/soup_builder.h"

#include <Eigen/Core>
#include <cmath>
#include <cstring>
#include <limits>

namespace shapegauge {

namespace {

template <typename Matrix, typename Row>
Matrix matrix_of(const std::vector<Row>& rows) {
  static_assert(sizeof(Row) == 3 * sizeof(typename Matrix::Scalar));
  Matrix matrix(static_cast<Eigen::Index>(rows.size()), 3);
  if (!rows.empty()) std::memcpy(matrix.data(), rows.data(), rows.size() * sizeof(Row));
  return matrix;
}

}  // namespace

void SoupBuilder::add_normal(const std::array<double, 3>& normal) {
  Eigen::Vector3d direction(normal[0], normal[1], normal[2]);
  // A length of 1 as far as rounding tells stays, so that a file that is read and written again is the same.
  const double length = direction.stableNorm();
  if (std::abs(length - 1) > 4 * std::numeric_limits<double>::epsilon()) direction.stableNormalize();
  normals_.push_back({direction[0], direction[1], direction[2]});
}

Shape SoupBuilder::shape() const {
  Shape shape{matrix_of<Points>(vertices_), matrix_of<Triangles>(triangles_)};
  if (is_cloud(shape) && normals_.size() == vertices_.size()) shape.normals = matrix_of<Points>(normals_);
  return shape;
}

}  // namespace shapegauge
