#include "shapegauge/core/render/render_shape.h"

#include <Eigen/Eigenvalues>
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
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

/// The image plane of a parallel projection, in front of the shape.
struct Camera {
  Eigen::Vector3d top_left;  ///< corner of the image
  Eigen::Vector3d right;     ///< unit
  Eigen::Vector3d up;        ///< unit
  Eigen::Vector3d forward;   ///< unit, away from the viewer
  Eigen::Vector3d light;     ///< unit, to where the light comes from: above the viewer's left shoulder
  double pixel = 0;          ///< side of a pixel in the shape's units

  [[nodiscard]] Eigen::Vector3d at(double column, double row, double depth) const {
    return top_left + pixel * (column * right - row * up) + depth * forward;
  }
};

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

void check(const RenderOptions& options) {
  constexpr int largest_side = 1 << 15;
  if (options.width < 1 || options.height < 1 || options.width > largest_side || options.height > largest_side ||
      options.rays_per_side < 1 || options.rays_per_side > 16 || !(options.margin >= 0 && options.margin < 0.5)) {
    throw InputError(
        fmt::format("an image of {} x {} pixels with {} rays per side and a margin of {} cannot be made; "
                    "the limits are 1 to {}, 1 to 16, and 0 to less than 0.5",
                    options.width, options.height, options.rays_per_side, options.margin, largest_side));
  }
  const double sine = options.up.normalized().cross(options.towards_viewer.normalized()).norm();
  if (!(sine > 1e-6)) throw InputError("the directions to the viewer and up must be finite, not zero and not parallel");
}

Camera camera_for(const Shape& shape, const RenderOptions& options) {
  Camera camera;
  camera.forward = -options.towards_viewer.normalized();
  camera.right = camera.forward.cross(options.up).normalized();
  camera.up = camera.right.cross(camera.forward);
  camera.light = (light_up * camera.up + light_right * camera.right - light_towards * camera.forward).normalized();
  Eigen::Matrix3d axes;
  axes << camera.right, camera.up, camera.forward;
  Eigen::AlignedBox3d box;  // in the camera's axes
  for (const std::int32_t v : shape.triangles.reshaped()) box.extend((shape.vertices.row(v) * axes).transpose());
  const double inside = 1 - 2 * options.margin;
  const double depth = box.sizes().norm();
  camera.pixel = std::max({box.sizes().x() / (inside * options.width), box.sizes().y() / (inside * options.height),
                           1e-9 * depth});  // a flat shape seen edge-on still has a picture
  const Eigen::Vector3d centre = box.center();
  camera.top_left = axes * Eigen::Vector3d(centre.x() - camera.pixel * options.width / 2,
                                           centre.y() + camera.pixel * options.height / 2, box.min().z() - depth / 2);
  return camera;
}

/// Unit normals, zero where there is none.
struct Normals {
  Points faces;
  Points vertices;  ///< means of those of the triangles around, by area
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

/// Points by column, row and depth, in units between rays of which a pixel has so many a side; the first ray's are 0.
Points projected_points(const Points& points, const Camera& camera, int per_side) {
  const double unit = per_side / camera.pixel;
  Eigen::Matrix3d axes;
  axes << unit * camera.right, -unit * camera.up, camera.forward;
  const Eigen::RowVector3d half(0.5, 0.5, 0);
  return ((points.rowwise() - camera.top_left.transpose()) * axes).rowwise() - half;
}

/// What is seen along a ray: the nearest triangle, -1 where there is none, and how far from the image plane it is.
struct Seen {
  std::int32_t triangle = -1;
  double depth = std::numeric_limits<double>::infinity();
};

/// The rays of some rows of the image, `per_side` by `per_side` a pixel, and what is seen along each.
class RayGrid {
 public:
  RayGrid(const Camera& camera, int columns, int per_side)
      : camera_(camera), per_side_(per_side), columns_(columns * per_side) {}

  /// - `projected`: the vertices' projected_points().
  void look_at(const Points& projected, const Triangles& triangles, int first_row, int rows) {
    first_row_ = first_row * per_side_;
    rows_ = rows * per_side_;
    seen_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), Seen());
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      const auto corner = [&](int k) { return projected.row(triangles(f, k)); };
      const auto [low, high] = std::minmax({corner(0).y(), corner(1).y(), corner(2).y()});
      if (high < first_row_ || low >= first_row_ + rows_) continue;
      look_at({corner(0), corner(1), corner(2)}, static_cast<std::int32_t>(f));
    }
  }

  /// - `column`, `row`: of the ray, the row from the first of all.
  [[nodiscard]] const Seen& at(int column, int row) const {
    return seen_[static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(column)];
  }

  [[nodiscard]] Eigen::Vector3d point(int column, int row) const {
    return camera_.at((column + 0.5) / per_side_, (row + 0.5) / per_side_, at(column, row).depth);
  }

 private:
  using Corners = std::array<Eigen::Vector3d, 3>;

  /// The side of an edge that a ray is on. It is taken from the same end by both triangles of the edge, so that none
  /// slips between them.
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
    /// Takes the columns that are outside from a row's. Where the edge crosses the row says about which, if it can be
    /// told.
    void cut(int row, int& first, int& last) const {
      if (along.y() == 0) {
        if (!has_inside(first, row)) last = first - 1;
        return;
      }
      const double crossing = start.x() + slope * (row - start.y());
      if ((sign > 0) == (along.y() < 0)) {  // what is inside is to the right
        if (crossing - 1 > first) first = static_cast<int>(std::min(crossing - 1, last + 1.0));
        while (first <= last && !has_inside(first, row)) ++first;
      } else {
        if (crossing + 1 < last) last = static_cast<int>(std::max(crossing + 1, first - 1.0));
        while (first <= last && !has_inside(last, row)) --last;
      }
    }
    Eigen::Vector3d start, along;
    double sign;
    double slope;  ///< columns a row
  };

  void look_at(const Corners& corners, std::int32_t triangle) {
    const Eigen::Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Eigen::Vector3d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const auto inside = [](double place, int end) {
      return static_cast<int>(std::clamp(place, -1.0, static_cast<double>(end)));
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

/// The shape with what its look needs.
class Scene {
 public:
  Scene(const Shape& shape, const std::vector<Colour>& colours, SampleSite site)
      : shape_(shape), colours_(colours), site_(site), normals_(normals_of(shape)) {}

  /// Red, green, blue and 255 of a point of a triangle.
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

  /// Blend of the corners' normals, those beyond a sharp edge replaced by the triangle's own.
  [[nodiscard]] Eigen::Vector3d normal(std::int32_t triangle, const Eigen::Vector3d& parts) const {
    static const double smooth = std::cos(smooth_edge_degrees / 180 * std::numbers::pi);
    const Eigen::Vector3d own = normals_.faces.row(triangle);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d corner = normals_.vertices.row(shape_.triangles(triangle, k));
      sum += parts[k] * (corner.dot(own) > smooth ? corner : own);
    }
    return sum.normalized();
  }

  /// Part of the colour that is seen (shading.h).
  [[nodiscard]] static double shade(Eigen::Vector3d normal, const Camera& camera) {
    if (normal.dot(camera.forward) > 0) normal = -normal;
    const double wrapped = (normal.dot(camera.light) + light_wrap) / (1 + light_wrap);
    return ambient_part + wrapped_part * std::max(0.0, wrapped) +
           frontal_part * std::max(0.0, -normal.dot(camera.forward));
  }

  const Shape& shape_;
  const std::vector<Colour>& colours_;
  SampleSite site_;
  Normals normals_;
};

/// Sum over a pixel's rays of colour and opacity, as the bytes of the pixel.
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
    rays.look_at(projected, shape.triangles, first, end - first);
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

/// One colour a triangle of the splats.
std::vector<Colour> colours_of_splats(const std::vector<Colour>& colours) {
  std::vector<Colour> result;
  result.reserve(triangles_per_splat * colours.size());
  for (const Colour& colour : colours) result.insert(result.end(), triangles_per_splat, colour);
  return result;
}

/// Below this skewness (third moment by the cube of the standard deviation) an axis counts as balanced: rounding must
/// not decide the view.
constexpr double balanced_skewness = 1e-3;

/// Calls visit(point, weight) for points with the moments of the surface up to the second: the triangles' corners and
/// centroids, a rule that is exact for polynomials of degree 2. Of a cloud, for its points.
template <typename Visit>
void visit_weighted_points(const Shape& shape, const Visit& visit) {
  for (Eigen::Index i = 0; i < shape.triangles.rows(); ++i) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(i, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(i, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(i, 2));
    const double area = (b - a).cross(c - a).norm() / 2;
    for (const auto& corner : {a, b, c}) visit(corner, area / 12);
    visit((a + b + c) / 3, area * 3 / 4);
  }
  if (!is_cloud(shape)) return;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) visit(shape.vertices.row(i).transpose(), 1);
}

/// The axis or its opposite.
Eigen::Vector3d pointed(const Eigen::Vector3d& axis, double variance, double third_moment) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  const bool balanced = std::abs(third_moment) <= balanced_skewness * std::pow(variance, 1.5);
  return (balanced ? axis[largest] : third_moment) < 0 ? Eigen::Vector3d(-axis) : axis;
}

/// Radius of a splat in radii of the disc that has the point's area. Of a plane with random points, exp(-2.25^2) or
/// 0.6 % stays uncovered.
constexpr double overlap = 2.25;
constexpr Eigen::Index neighbours = 12;

/// Direction in which the point and its neighbours extend least.
Eigen::Vector3d fitted_normal(const Points& points, const PointNeighbours& nearest, Eigen::Index i) {
  const auto around = nearest.indices.row(i);
  Eigen::Vector3d mean = points.row(i);
  for (const std::int32_t j : around) mean += points.row(j).transpose();
  mean /= static_cast<double>(around.size() + 1);
  const auto spread_of = [&](Eigen::Index j) -> Eigen::Matrix3d {
    const Eigen::Vector3d d = points.row(j).transpose() - mean;
    return d * d.transpose();
  };
  Eigen::Matrix3d spread = spread_of(i);
  for (const std::int32_t j : around) spread += spread_of(j);
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

void add_splat(Shape& mesh, Eigen::Index i, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
               double radius) {
  constexpr int corners = triangles_per_splat + 2;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    mesh.vertices.row(corners * i + k) = centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
  const auto first = static_cast<std::int32_t>(corners * i);
  for (int k = 0; k < triangles_per_splat; ++k) {
    mesh.triangles.row(triangles_per_splat * i + k) << first, first + k + 1, first + k + 2;
  }
}

}  // namespace

Image render_shape(const Shape& shape, const std::vector<Colour>& colours, SampleSite site,
                   const RenderOptions& options) {
  check(shape, colours, site);
  check(options);
  if (!is_cloud(shape)) return draw(shape, colours, site, options);
  return draw(splats(shape), colours_of_splats(colours), SampleSite::faces, options);
}

RenderOptions principal_view(const Shape& shape, RenderOptions options) {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    mass += weight;
    centre += weight * point;
  });
  if (!(mass > 0) || !std::isfinite(mass) || !centre.allFinite()) return options;
  centre /= mass;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Vector3d arm = point - centre;
    second += (weight / mass * arm) * arm.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(second);  // ascending
  const Eigen::Matrix3d to_axes = principal.eigenvectors().transpose();
  Eigen::Vector3d third = Eigen::Vector3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Array3d along = to_axes * (point - centre);
    third += (weight / mass * along * along * along).matrix();
  });
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = pointed(principal.eigenvectors().col(k), principal.eigenvalues()[k], third[k]);
  options.up = axes.col(1);
  options.towards_viewer = axes.col(0) + 0.35 * axes.col(2) + 0.45 * axes.col(1);
  return options;
}

Shape splats(const Shape& cloud) {
  const UnitFrame frame = unit_frame(cloud);
  const Eigen::Index n = cloud.vertices.rows();
  Points points(n, 3);  // in coordinates near 1, whose squares neither vanish nor overflow
  for (Eigen::Index i = 0; i < n; ++i) points.row(i) = frame.to_unit(cloud.vertices.row(i).transpose()).transpose();
  const Eigen::VectorXd weights = point_weights(points);
  const bool has_all_normals = cloud.normals.rows() > 0 && (cloud.normals.array() != 0).rowwise().any().all();
  const PointNeighbours nearest = has_all_normals ? PointNeighbours() : nearest_neighbours(points, neighbours);
  Shape mesh;
  mesh.vertices.resize((triangles_per_splat + 2) * n, 3);
  mesh.triangles.resize(triangles_per_splat * n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (cloud.normals.rows() > 0) normal = cloud.normals.row(i);
    if (normal.isZero(0)) normal = fitted_normal(points, nearest, i);
    add_splat(mesh, i, points.row(i), normal, overlap * std::sqrt(weights[i] / std::numbers::pi));
  }
  mesh.vertices = (mesh.vertices * frame.diagonal).rowwise() + frame.centre.transpose();
  return mesh;
}

}  // namespace shapegauge
