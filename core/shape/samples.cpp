// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

/// Returns cumulative areas by triangle; duplicates add none.
Eigen::VectorXd running_areas(const Shape& mesh) {
  Eigen::VectorXd areas = triangle_areas(mesh);
  const std::vector<std::int32_t> first = first_duplicates(mesh.triangles, welded_vertices(mesh.vertices));
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    if (first[static_cast<std::size_t>(f)] != f) areas[f] = 0;
  }
  for (Eigen::Index f = 1; f < areas.size(); ++f) areas[f] += areas[f - 1];
  const double total = areas.size() > 0 ? areas[areas.size() - 1] : 0;
  if (!std::isnormal(total)) {
    throw InputError(
        fmt::format("the surface cannot be sampled: the area of its {} triangles is {}; it needs a triangle of "
                    "positive, finite area",
                    areas.size(), total));
  }
  return areas;
}

/// Returns a point uniform on a triangle (Turk 1990).
Eigen::RowVector3d point_on(const Shape& mesh, Eigen::Index triangle, RandomNumbers& random) {
  const double root = std::sqrt(random.uniform(0, 1));
  const double along = random.uniform(0, 1);
  const auto corners = mesh.triangles.row(triangle);
  return (1 - root) * mesh.vertices.row(corners[0]) + root * (1 - along) * mesh.vertices.row(corners[1]) +
         root * along * mesh.vertices.row(corners[2]);
}

using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners_of(const Shape& shape, Eigen::Index triangle) {
  Corners corners;
  for (int k = 0; k < 3; ++k) corners[k] = shape.vertices.row(shape.triangles(triangle, k)).transpose();
  return corners;
}

/// Shape of a triangle independent of its size; `degenerate` if its corners are collinear up to rounding.
struct TriangleForm {
  bool degenerate = true;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double area = 0;
  std::array<double, 3> angles = {};
  std::array<double, 3> mixed_areas = {};  ///< area assigned to each corner; they sum to `area`
};

/// Computes the mixed areas (Meyer et al. 2003, section 3.3): the corners' Voronoi regions if no angle is obtuse,
/// otherwise half of the area for the obtuse corner and a quarter for each of the others. In units near the triangle's
/// size.
std::array<double, 3> mixed_areas(double area, const std::array<double, 3>& cotangents,
                                  const std::array<double, 3>& squared_opposite_edges) {
  std::array<double, 3> parts = {};
  const auto obtuse = std::find_if(cotangents.begin(), cotangents.end(), [](double c) { return c < 0; });
  if (obtuse != cotangents.end()) {
    parts.fill(area / 4);
    parts[obtuse - cotangents.begin()] = area / 2;
    return parts;
  }
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    parts[k] = (squared_opposite_edges[i] * cotangents[i] + squared_opposite_edges[j] * cotangents[j]) / 8;
  }
  return parts;
}

TriangleForm form_of(const Corners& corners) {
  TriangleForm form;
  std::array<Eigen::Vector3d, 3> edges;  // edges[k] is opposite corner k
  double longest = 0;
  double largest_coordinate = 0;
  for (int k = 0; k < 3; ++k) {
    edges[k] = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    longest = std::max(longest, edges[k].cwiseAbs().maxCoeff());
    largest_coordinate = std::max(largest_coordinate, corners[k].cwiseAbs().maxCoeff());
  }
  if (!(longest > 0)) return form;
  // In units near the triangle's size products stay in range; a power of two avoids rounding.
  const double unit = std::exp2(std::ilogb(longest));
  for (Eigen::Vector3d& edge : edges) edge /= unit;
  // The same product as in CGAL's sdf_values, including its rounding: the first ray of a cone depends on whether a
  // component of the normal is exactly zero.
  const Eigen::Vector3d cross = edges[0].cross(-edges[2]);
  const double twice_area = cross.norm();
  // Coordinates rounded to double move each corner by up to an epsilon of their size.
  if (!(twice_area > 4 * std::numeric_limits<double>::epsilon() * (largest_coordinate / unit))) return form;

  form.degenerate = false;
  form.normal = cross / twice_area;
  form.area = twice_area / 2 * unit * unit;
  std::array<double, 3> cotangents = {};
  std::array<double, 3> squared_edges = {};
  for (int k = 0; k < 3; ++k) {
    const double dot = -edges[(k + 1) % 3].dot(edges[(k + 2) % 3]);
    cotangents[k] = dot / twice_area;
    form.angles[k] = std::atan2(twice_area, dot);
    squared_edges[k] = edges[k].squaredNorm();
  }
  form.mixed_areas = mixed_areas(twice_area / 2, cotangents, squared_edges);
  for (double& area : form.mixed_areas) area = area * unit * unit;
  return form;
}

Samples empty_samples(SampleSite site, Eigen::Index count) {
  Samples samples;
  samples.site = site;
  samples.points = Points::Zero(count, 3);
  samples.normals = Points::Zero(count, 3);
  samples.weights = Eigen::VectorXd::Zero(count);
  return samples;
}

Samples sample_faces(const Shape& shape) {
  Samples samples = empty_samples(SampleSite::faces, shape.triangles.rows());
  const std::vector<std::int32_t> first = first_duplicates(shape.triangles, welded_vertices(shape.vertices));
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    if (const std::int32_t first_copy = first[static_cast<std::size_t>(f)]; first_copy != f) {
      samples.points.row(f) = samples.points.row(first_copy);
      samples.normals.row(f) = samples.normals.row(first_copy);
      continue;
    }
    const Corners corners = corners_of(shape, f);
    const TriangleForm form = form_of(corners);
    samples.points.row(f) = (corners[0] / 3 + corners[1] / 3 + corners[2] / 3).transpose();
    samples.normals.row(f) = form.normal.transpose();
    samples.weights[f] = form.area;
  }
  return samples;
}

Samples sample_cloud(const Shape& shape) {
  Samples samples = empty_samples(SampleSite::vertices, shape.vertices.rows());
  samples.points = shape.vertices;
  samples.normals = shape.normals.isZero(0) ? unsigned_point_normals(shape.vertices) : shape.normals;
  samples.weights = point_weights(shape.vertices);
  return samples;
}

/// Replaces cancelling normals. Where triangles are reversed at random, their normals cancel although all lie in about
/// one plane. The direction is then that of most normals, up to sign.
void settle_cancelled_normals(const Shape& shape, const Eigen::VectorXd& total_angles, Points& sums) {
  constexpr double cancelled = 0.5;  // remaining fraction of the sum's length
  constexpr double agreed = 0.8;     // fraction of the squared normals along one axis
  std::vector<std::int32_t> square_of(static_cast<std::size_t>(shape.vertices.rows()), -1);
  std::vector<Eigen::Matrix3d> squares;
  for (Eigen::Index v = 0; v < sums.rows(); ++v) {
    const double length = sums.row(v).norm();
    if (length >= cancelled * total_angles[v] || length <= 1e-12 * total_angles[v]) continue;
    square_of[static_cast<std::size_t>(v)] = static_cast<std::int32_t>(squares.size());
    squares.emplace_back(Eigen::Matrix3d::Zero());
  }
  if (squares.empty()) return;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t at = square_of[static_cast<std::size_t>(shape.triangles(f, k))];
      if (at < 0) continue;
      const TriangleForm form = form_of(corners_of(shape, f));
      if (form.degenerate) continue;
      squares[static_cast<std::size_t>(at)] += form.angles[k] * form.normal * form.normal.transpose();
    }
  }
  for (Eigen::Index v = 0; v < sums.rows(); ++v) {
    if (square_of[static_cast<std::size_t>(v)] < 0) continue;
    const auto solver = eigen_decomposition(squares[static_cast<std::size_t>(square_of[static_cast<std::size_t>(v)])]);
    if (solver.eigenvalues()[2] < agreed * solver.eigenvalues().sum()) continue;
    const Eigen::RowVector3d direction = solver.eigenvectors().col(2).transpose();
    sums.row(v) = total_angles[v] * (direction.dot(sums.row(v)) < 0 ? -direction : direction);
  }
}

Samples sample_vertices(const Shape& original) {
  const DistinctTriangles distinct = distinct_triangles(original);
  const Shape& shape = distinct.shape;
  Samples samples = empty_samples(SampleSite::vertices, shape.vertices.rows());
  samples.points = shape.vertices;
  Eigen::VectorXd total_angles = Eigen::VectorXd::Zero(shape.vertices.rows());
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const TriangleForm form = form_of(corners_of(shape, f));
    if (form.degenerate) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Index v = shape.triangles(f, k);
      samples.weights[v] += form.mixed_areas[k];
      samples.normals.row(v) += form.angles[k] * form.normal.transpose();
      total_angles[v] += form.angles[k];
    }
  }
  settle_cancelled_normals(shape, total_angles, samples.normals);
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    const double length = samples.normals.row(v).norm();
    // Cancelling normals (a sheet with two sides) leave rounding noise, not a direction.
    if (length > 1e-12 * total_angles[v]) {
      samples.normals.row(v) /= length;
    } else {
      samples.normals.row(v).setZero();
    }
  }
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    samples.normals.row(v) = samples.normals.row(distinct.vertex_of[static_cast<std::size_t>(v)]).eval();
  }
  return samples;
}

Samples some_of(const Samples& all, Eigen::Index count, RandomNumbers& random) {
  const auto n = static_cast<std::size_t>(all.points.rows());
  const std::vector<bool> marks = random_subset(n, static_cast<std::size_t>(count), random);
  std::vector<Eigen::Index> chosen;
  for (std::size_t i = 0; i < n; ++i) {
    if (marks[i]) chosen.push_back(static_cast<Eigen::Index>(i));
  }
  Samples some = empty_samples(all.site, std::ssize(chosen));
  some.points = all.points(chosen, Eigen::all);
  some.normals = all.normals(chosen, Eigen::all);
  some.weights = all.weights(chosen);
  // The chosen samples also represent the others.
  const double sum = some.weights.sum();
  if (sum > 0) some.weights *= all.weights.sum() / sum;
  return some;
}

}  // namespace

SurfacePoints stratified_points(const Shape& mesh, Eigen::Index count, RandomNumbers& random) {
  if (count < 1) throw InputError(fmt::format("the number of points must be at least 1, not {}", count));
  const Eigen::VectorXd areas = running_areas(mesh);
  const double total = areas.size() > 0 ? areas[areas.size() - 1] : 0;
  const double part = total / static_cast<double>(count);
  SurfacePoints result{Points(count, 3), std::vector<std::int32_t>(static_cast<std::size_t>(count))};
  for (Eigen::Index i = 0; i < count; ++i) {
    const double area = part * random.uniform(static_cast<double>(i), static_cast<double>(i + 1));
    // The first cumulative sum beyond it belongs to a triangle with area; rounding must not exceed the last one.
    const double below_total = std::min(area, std::nextafter(total, 0.0));
    const auto triangle = std::upper_bound(areas.begin(), areas.end(), below_total) - areas.begin();
    result.points.row(i) = point_on(mesh, triangle, random);
    result.triangles[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(triangle);
  }
  return result;
}

Samples sample_shape(const Shape& shape, SampleSite site) {
  require_usable(shape);
  if (is_cloud(shape)) return sample_cloud(shape);
  if (site == SampleSite::surface) throw InputError("sampling the surface requires a number of samples");
  return site == SampleSite::faces ? sample_faces(shape) : sample_vertices(shape);
}

Samples sample_surface(const Shape& shape, Eigen::Index count) {
  require_usable(shape);
  RandomNumbers random(1);
  if (is_cloud(shape)) {
    if (count < 1) throw InputError(fmt::format("the number of samples must be at least 1, not {}", count));
    const Samples all = sample_cloud(shape);
    return count < all.points.rows() ? some_of(all, count, random) : all;
  }
  SurfacePoints on_surface = stratified_points(shape, count, random);
  Samples samples = empty_samples(SampleSite::surface, count);
  samples.points = std::move(on_surface.points);
  samples.triangles = std::move(on_surface.triangles);
  samples.weights.setConstant(surface_area(shape) / static_cast<double>(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    const TriangleForm form = form_of(corners_of(shape, samples.triangles[static_cast<std::size_t>(i)]));
    samples.normals.row(i) = form.normal.transpose();
  }
  return samples;
}

}  // namespace shapegauge
