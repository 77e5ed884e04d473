#include "shapegauge/core/io/shape_format.h"

#include <Eigen/Core>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/shape.h"

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

std::string message_truncated(std::int64_t got, std::int64_t expected, std::string_view what) {
  return fmt::format("ends after {} of {} {}; the file is truncated or its header is wrong", got, expected, what);
}

std::string message_no_such_vertex(std::int64_t face, std::int64_t vertex, std::int64_t vertices) {
  return fmt::format("face {} refers to vertex {}, but the vertices are numbered 0 to {}", face, vertex, vertices - 1);
}

std::string message_not_finite(std::int64_t vertex, std::string_view what) {
  return fmt::format("vertex {} has a {} that is not a finite number; repair or remove the file", vertex, what);
}

std::string message_no_triangles(std::int64_t faces) {
  return fmt::format("none of its {} faces has three vertices", faces);
}

void require_writable(const std::filesystem::path& path, const Shape& shape) {
  if (const auto defect = defect_of(shape))
    throw InputError(fmt::format("cannot write {}: {}", path.string(), *defect));
  if (has_cloud_normals(shape) && shape.normals.rows() != shape.vertices.rows()) {
    throw InputError(fmt::format("cannot write {}: {} normals for {} points", path.string(), shape.normals.rows(),
                                 shape.vertices.rows()));
  }
  if (has_cloud_normals(shape) && !shape.normals.allFinite()) {
    throw InputError(fmt::format("cannot write {}: a normal is not finite", path.string()));
  }
}

}  // namespace shapegauge
