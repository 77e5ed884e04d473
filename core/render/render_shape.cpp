// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/render/render_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/render/shading.h"
#include "shapegauge/core/render/splats.h"

namespace shapegauge {

namespace {

void check(const Shape& shape, const std::vector<Colour>& colours, SampleSite site) {
  require_usable(shape);
  const Eigen::Index sites = site == SampleSite::faces ? shape.triangles.rows() : shape.vertices.rows();
  if (static_cast<Eigen::Index>(colours.size()) != sites) {
    throw InputError(fmt::format("{} colours for {} {} of the shape", colours.size(), sites,
                                 site == SampleSite::faces ? "triangles" : "vertices"));
  }
  const double diagonal = bounding_box_diagonal(shape);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) throw InputError("nothing to draw: the shape has no finite extent");
}

/// Unit normals; zero if undefined.
struct Normals {
  Points faces;
  Points vertices;  ///< area-weighted means of the normals of adjacent triangles
};

Normals normals_of(const Shape& shape) {
  Normals normals{.faces = Points::Zero(shape.triangles.rows(), 3), .vertices = Points::Zero(shape.vertices.rows(), 3)};
  const double unit = bounding_box_diagonal(shape);  // of which no products leave the range
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::RowVector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::RowVector3d ab = (shape.vertices.row(shape.triangles(f, 1)) - a) / unit;
    const Eigen::RowVector3d ac = (shape.vertices.row(shape.triangles(f, 2)) - a) / unit;
    const Eigen::RowVector3d cross = ab.cross(ac);
    const double length = cross.norm();
    if (!(length > 0)) continue;
    normals.faces.row(f) = cross / length;
    for (int k = 0; k < 3; ++k) normals.vertices.row(shape.triangles(f, k)) += cross;
  }
  for (Eigen::Index v = 0; v < normals.vertices.rows(); ++v) {
    const double length = normals.vertices.row(v).norm();
    if (length > 0) normals.vertices.row(v) /= length;
  }
  return normals;
}

/// Returns points by column, row and depth, in units of the ray spacing; the first ray is at 0.
Points projected_points(const Points& points, const Camera& camera, int per_side) {
  const double unit = per_side / camera.pixel;
  Eigen::Matrix3d axes;
  axes << unit * camera.right, -unit * camera.up, camera.forward;
  const Eigen::RowVector3d half(0.5, 0.5, 0);
  return ((points.rowwise() - camera.top_left.transpose()) * axes).rowwise() - half;
}

/// Result of a ray: the nearest triangle, or -1, and its distance from the image plane.
struct Seen {
  std::int32_t triangle = -1;
  double depth = std::numeric_limits<double>::infinity();
};

/// Rays of some rows of the image, `per_side` by `per_side` per pixel, with their results.
class RayGrid {
 public:
  RayGrid(const Camera& camera, int columns, int per_side)
      : camera_(camera), per_side_(per_side), columns_(columns * per_side) {}

  /// Rasterises triangles. `projected` are the vertices' projected_points().
  void rasterise(const Points& projected, const Triangles& triangles, int first_row, int rows) {
    first_row_ = first_row * per_side_;
    rows_ = rows * per_side_;
    seen_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), Seen());
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      const auto corner = [&](int k) { return projected.row(triangles(f, k)); };
      const auto [low, high] = std::minmax({corner(0).y(), corner(1).y(), corner(2).y()});
      if (high < first_row_ || low >= first_row_ + rows_) continue;
      rasterise({corner(0), corner(1), corner(2)}, static_cast<std::int32_t>(f));
    }
  }

  /// `column` and `row` are those of the ray; rows count from the first of all.
  [[nodiscard]] const Seen& at(int column, int row) const {
    return seen_[static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(column)];
  }

  [[nodiscard]] Eigen::Vector3d point(int column, int row) const {
    return camera_.at((column + 0.5) / per_side_, (row + 0.5) / per_side_, at(column, row).depth);
  }

 private:
  using Corners = std::array<Eigen::Vector3d, 3>;

  /// Side of an edge that a ray is on. Both triangles of the edge evaluate it from the same end, which prevents gaps.
  struct Edge {
    Edge(Eigen::Vector3d from, Eigen::Vector3d to, double orientation) : sign(orientation) {
      if (std::pair(to.x(), to.y()) < std::pair(from.x(), from.y())) {
        std::swap(from, to);
        sign = -sign;
      }
      start = from;
      along = to - from;
      slope = along.x() / along.y();
    }
    [[nodiscard]] bool has_inside(double x, double y) const {
      return sign * (along.x() * (y - start.y()) - along.y() * (x - start.x())) >= 0;
    }
    /// Removes the columns outside the edge from a row, if the edge's crossing is well conditioned.
    void cut(int row, int& first, int& last) const {
      if (along.y() == 0) {
        if (!has_inside(first, row)) last = first - 1;
        return;
      }
      const double crossing = start.x() + slope * (row - start.y());
      if ((sign > 0) == (along.y() < 0)) {  // the interior is to the right
        if (crossing - 1 > first) first = static_cast<int>(std::min(crossing - 1, last + 1.0));
        while (first <= last && !has_inside(first, row)) ++first;
      } else {
        if (crossing + 1 < last) last = static_cast<int>(std::max(crossing + 1, first - 1.0));
        while (first <= last && !has_inside(last, row)) --last;
      }
    }
    Eigen::Vector3d start, along;
    double sign;
    double slope;  ///< columns per row
  };

  void rasterise(const Corners& corners, std::int32_t triangle) {
    const Eigen::Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Eigen::Vector3d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const auto inside = [](double coordinate, int end) {
      return static_cast<int>(std::clamp(coordinate, -1.0, static_cast<double>(end)));
    };
    const int first_row = std::max(inside(std::ceil(low.y()), first_row_ + rows_), first_row_);
    const int last_row = inside(std::floor(high.y()), first_row_ + rows_ - 1);
    const int first_column = std::max(inside(std::ceil(low.x()), columns_), 0);
    const int last_column = inside(std::floor(high.x()), columns_ - 1);
    if (first_row > last_row || first_column > last_column) return;
    const Eigen::Vector3d cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (cross.z() == 0) return;  // seen from its edge
    const std::array<Edge, 3> edges{Edge(corners[0], corners[1], cross.z()), Edge(corners[1], corners[2], cross.z()),
                                    Edge(corners[2], corners[0], cross.z())};
    const double rise_x = cross.x() / cross.z();
    const double rise_y = cross.y() / cross.z();
    for (int row = first_row; row <= last_row; ++row) {
      int first = first_column;
      int last = last_column;
      for (const Edge& edge : edges) edge.cut(row, first, last);
      Seen* seen = &seen_[static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_)];
      for (int column = first; column <= last; ++column) {
        const double rise = rise_x * (column - corners[0].x()) + rise_y * (row - corners[0].y());
        const double depth = std::clamp(corners[0].z() - rise, low.z(), high.z());
        if (depth < seen[column].depth) seen[column] = {triangle, depth};
      }
    }
  }

  const Camera& camera_;
  int per_side_;
  int columns_;
  int first_row_ = 0;
  int rows_ = 0;
  std::vector<Seen> seen_;
};

/// Shape with its rendering data.
class Scene {
 public:
  Scene(const Shape& shape, const std::vector<Colour>& colours, SampleSite site)
      : shape_(shape), colours_(colours), site_(site), normals_(normals_of(shape)) {}

  /// Returns red, green, blue and 255 for a point of a triangle.
  [[nodiscard]] Eigen::Array4d look(std::int32_t triangle, const Eigen::Vector3d& point, const Camera& camera) const {
    const Eigen::Vector3d parts = barycentric(triangle, point);
    Eigen::Array4d result;
    result << colour(triangle, parts) * shade(normal(triangle, parts), camera), 255;
    return result;
  }

 private:
  [[nodiscard]] Eigen::Vector3d barycentric(std::int32_t triangle, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d a = shape_.vertices.row(shape_.triangles(triangle, 0));
    const Eigen::Vector3d ab = shape_.vertices.row(shape_.triangles(triangle, 1)).transpose() - a;
    const Eigen::Vector3d ac = shape_.vertices.row(shape_.triangles(triangle, 2)).transpose() - a;
    const Eigen::Vector3d n = normals_.faces.row(triangle);
    const double twice_area = n.dot(ab.cross(ac));
    if (!(twice_area > 0)) return Eigen::Vector3d::Constant(1.0 / 3);
    const double b = n.dot((point - a).cross(ac)) / twice_area;
    const double c = n.dot(ab.cross(point - a)) / twice_area;
    const Eigen::Vector3d parts = Eigen::Vector3d(1 - b - c, b, c).cwiseMax(0);
    return parts / parts.sum();
  }

  [[nodiscard]] Eigen::Array3d colour(std::int32_t triangle, const Eigen::Vector3d& parts) const {
    const auto channels = [](const Colour& c) { return Eigen::Array3d(c[0], c[1], c[2]); };
    if (site_ == SampleSite::faces) return channels(colours_[triangle]);
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    for (int k = 0; k < 3; ++k) sum += parts[k] * channels(colours_[shape_.triangles(triangle, k)]);
    return sum;
  }

  /// Interpolates the corners' normals; those beyond a sharp edge are replaced by the triangle's own.
  [[nodiscard]] Eigen::Vector3d normal(std::int32_t triangle, const Eigen::Vector3d& parts) const {
    static const double smooth = std::cos(smooth_edge_degrees / 180 * std::numbers::pi);
    const Eigen::Vector3d flat = normals_.faces.row(triangle);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d corner = normals_.vertices.row(shape_.triangles(triangle, k));
      sum += parts[k] * (corner.dot(flat) > smooth ? corner : flat);
    }
    return sum.normalized();
  }

  /// Returns the visible part of the colour (shading.h).
  [[nodiscard]] static double shade(Eigen::Vector3d normal, const Camera& camera) {
    if (normal.dot(camera.forward) > 0) normal = -normal;
    const double wrapped = (normal.dot(camera.light) + light_wrap) / (1 + light_wrap);
    return ambient_fraction + wrapped_fraction * std::max(0.0, wrapped) +
           frontal_fraction * std::max(0.0, -normal.dot(camera.forward));
  }

  const Shape& shape_;
  const std::vector<Colour>& colours_;
  SampleSite site_;
  Normals normals_;
};

/// Converts the sum of colour and opacity over a pixel's rays to the pixel's bytes.
std::array<std::uint8_t, 4> pixel_of(const Eigen::Array4d& sum, int rays, bool transparent) {
  const double covered = sum[3] / 255;
  Eigen::Array4d pixel = sum / rays;
  if (transparent) {
    if (covered > 0) pixel.head<3>() = sum.head<3>() / covered;
  } else {
    pixel.head<3>() += 255 * (1 - covered / rays);
    pixel[3] = 255;
  }
  std::array<std::uint8_t, 4> bytes = {};
  for (int k = 0; k < 4; ++k) bytes[k] = static_cast<std::uint8_t>(std::lround(std::clamp(pixel[k], 0.0, 255.0)));
  return bytes;
}

Image draw(const Shape& shape, const std::vector<Colour>& colours, SampleSite site, const RenderOptions& options) {
  constexpr int rows_at_once = 16;
  const Camera camera = camera_for(shape, options);
  const Scene scene(shape, colours, site);
  const int n = options.rays_per_side;
  const Points projected = projected_points(shape.vertices, camera, n);
  Image image{.width = options.width, .height = options.height, .pixels = {}};
  image.pixels.resize(4 * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
  parallel_for(0, (options.height + rows_at_once - 1) / rows_at_once, [&](int band) {
    const int first = band * rows_at_once;
    const int end = std::min(first + rows_at_once, options.height);
    RayGrid rays(camera, options.width, n);
    rays.rasterise(projected, shape.triangles, first, end - first);
    auto target = image.pixels.begin() + 4 * static_cast<std::ptrdiff_t>(options.width) * first;
    for (int row = first; row < end; ++row) {
      for (int column = 0; column < options.width; ++column) {
        Eigen::Array4d sum = Eigen::Array4d::Zero();
        for (int k = 0; k < n * n; ++k) {
          const int x = column * n + k % n;
          const int y = row * n + k / n;
          const std::int32_t triangle = rays.at(x, y).triangle;
          if (triangle >= 0) sum += scene.look(triangle, rays.point(x, y), camera);
        }
        target = std::ranges::copy(pixel_of(sum, n * n, options.transparent), target).out;
      }
    }
  });
  return image;
}

/// Returns one colour per triangle of the splats.
std::vector<Colour> colours_of_splats(const std::vector<Colour>& colours) {
  std::vector<Colour> result;
  result.reserve(triangles_per_splat * colours.size());
  for (const Colour& colour : colours) result.insert(result.end(), triangles_per_splat, colour);
  return result;
}

}  // namespace

Image render_shape(const Shape& shape, const std::vector<Colour>& colours, SampleSite site,
                   const RenderOptions& options) {
  check(shape, colours, site);
  if (!is_cloud(shape)) return draw(shape, colours, site, options);
  return draw(splats(shape), colours_of_splats(colours), SampleSite::faces, options);
}

}  // namespace shapegauge
