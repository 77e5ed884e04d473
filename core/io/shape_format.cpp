// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/shape_format.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/triangulate_polygon.h"
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
  // A length of 1, up to rounding, stays: reading and writing must not change a file.
  const double length = direction.stableNorm();
  if (std::abs(length - 1) > 4 * std::numeric_limits<double>::epsilon()) direction.stableNormalize();
  normals_.push_back({direction[0], direction[1], direction[2]});
}

void SoupBuilder::number_polygons() {
  is_numbered_ = true;
  polygons_.resize(triangles_.size());
  std::iota(polygons_.begin(), polygons_.end(), 0);
}

std::vector<std::array<std::int32_t, 3>> SoupBuilder::fan_replacement(std::size_t begin, std::size_t end) const {
  if (end - begin < 2) return {};
  std::vector<std::int32_t> corners = {triangles_[begin][0], triangles_[begin][1]};
  for (std::size_t f = begin; f < end; ++f) corners.push_back(triangles_[f][2]);
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(corners.size());
  for (const std::int32_t corner : corners) positions.emplace_back(vertices_[static_cast<std::size_t>(corner)].data());
  std::vector<PolygonTriangle> others = triangles_in_place_of_fan(positions);
  for (PolygonTriangle& triangle : others) {
    for (std::int32_t& corner : triangle) corner = corners[static_cast<std::size_t>(corner)];
  }
  return others;
}

void SoupBuilder::replace_fans() {
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> polygons;
  triangles.reserve(triangles_.size());
  polygons.reserve(polygons_.size());
  for (std::size_t begin = 0, end = 0; begin < triangles_.size(); begin = end) {
    const std::int32_t polygon = polygons_[begin];
    while (end < triangles_.size() && polygons_[end] == polygon) ++end;
    const std::vector<std::array<std::int32_t, 3>> others = fan_replacement(begin, end);
    if (others.empty()) {
      triangles.insert(triangles.end(), triangles_.begin() + static_cast<std::ptrdiff_t>(begin),
                       triangles_.begin() + static_cast<std::ptrdiff_t>(end));
    } else {
      triangles.insert(triangles.end(), others.begin(), others.end());
    }
    polygons.resize(triangles.size(), polygon);
  }
  triangles_ = std::move(triangles);
  polygons_ = std::move(polygons);
}

Shape SoupBuilder::shape() {
  if (!is_numbered_ && !triangles_.empty() && triangles_.size() != static_cast<std::size_t>(faces_)) {
    number_polygons();
  }
  if (!polygons_.empty()) replace_fans();
  Shape shape{matrix_of<Points>(vertices_), matrix_of<Triangles>(triangles_)};
  shape.polygons = {.of_triangle = polygons_, .count = faces_};
  const bool has_normals = std::ranges::any_of(normals_, [](const auto& n) { return n != std::array<double, 3>{}; });
  if (is_cloud(shape) && has_normals && normals_.size() == vertices_.size()) {
    shape.normals = matrix_of<Points>(normals_);
  }
  return shape;
}

std::string_view first_line_of_data(std::string_view text) {
  text = without_byte_order_mark(text);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trim(text.substr(0, end));
    if (!line.empty() && line.front() != '#') return line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
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

std::string message_too_many_corners(std::int64_t face) {
  return fmt::format("face {} has more than {} vertices; triangulate it", face, max_polygon_corners);
}

void require_writable(const std::filesystem::path& path, const Shape& shape) {
  if (const auto defect = find_defect(shape))
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
