#include "shapegauge/core/io/soup_builder.h"

#include <cstring>

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

Shape SoupBuilder::shape() const { return {matrix_of<Points>(vertices_), matrix_of<Triangles>(triangles_)}; }

}  // namespace shapegauge
