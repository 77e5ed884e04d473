// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/mesh_implicit_surface.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Robust_circumcenter_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cell_base_3.h>
#include <CGAL/Surface_mesh_vertex_base_3.h>
#include <CGAL/make_surface_mesh.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "shapegauge/datasets/generator/shape_of_mesh.h"

// Internal to the sources that use CGAL.

namespace shapegauge {

/// Vertex or cell with a time stamp, by which CGAL orders handles. Ordering by address would make the refinement of a
/// surface vary between runs.
template <typename Base>
class TimeStamped : public Base {
 public:
  using Base::Base;
  using Has_timestamp = CGAL::Tag_true;

  template <typename DataStructure>
  struct Rebind_TDS {
    using Other = TimeStamped<typename Base::template Rebind_TDS<DataStructure>::Other>;
  };

  [[nodiscard]] std::size_t time_stamp() const { return time_stamp_; }
  void set_time_stamp(const std::size_t& time_stamp) { time_stamp_ = time_stamp; }

 private:
  std::size_t time_stamp_ = static_cast<std::size_t>(-1);  // CGAL's sign for "none yet"
};

/// CGAL's default triangulation for surface meshes, with time stamps.
using SurfaceTriangulationTraits =
    CGAL::Robust_circumcenter_traits_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using SurfaceTriangulation = CGAL::Delaunay_triangulation_3<
    SurfaceTriangulationTraits,
    CGAL::Triangulation_data_structure_3<
        TimeStamped<CGAL::Surface_mesh_vertex_base_3<SurfaceTriangulationTraits>>,
        TimeStamped<CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<
            SurfaceTriangulationTraits, CGAL::Surface_mesh_cell_base_3<SurfaceTriangulationTraits>>>>>;

namespace {

using Triangulation = SurfaceTriangulation;
using SurfaceComplex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Kernel = Triangulation::Geom_traits;
using Point = Kernel::Point_3;
using ClosedMesh = CGAL::Surface_mesh<Point>;

Eigen::Vector3d to_eigen(const Point& p) { return {p.x(), p.y(), p.z()}; }
Point to_cgal(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

double squared_size(const ImplicitSurface& surface, double coarseness, const Eigen::Vector3d& point) {
  return coarseness * coarseness * surface.radius() * surface.nearest_limb(point).thin_radius;
}

// Finds the point of the surface on a segment whose ends have values of opposite sign, by the Illinois variant of the
// false position method, to within 1e-7 of the surface's extent.
Eigen::Vector3d surface_point_between(const ImplicitSurface& surface, Eigen::Vector3d a, double value_a,
                                      Eigen::Vector3d b, double value_b) {
  const double tolerance = 1e-7 * surface.radius();
  for (int i = 0; i < 60; ++i) {
    Eigen::Vector3d middle = a + value_a / (value_a - value_b) * (b - a);
    const double value = surface(middle);
    if (std::abs(value) <= tolerance) return middle;
    // b is the end that moves; the value of an end that stays is halved.
    if ((value < 0) == (value_b < 0)) {
      value_a /= 2;
    } else {
      a = b;
      value_a = value_b;
    }
    b = middle;
    value_b = value;
  }
  return b;
}

// Adapts the surface to CGAL's surface mesher (a model of its concept SurfaceMeshTraits_3), which asks for
// intersections with segments. CGAL's own Implicit_surface_3 bisects the segment; false position needs a third of the
// evaluations.
class SurfaceTraits {
 public:
  using Surface_3 = ImplicitSurface;
  using Intersection_point = Point;
  using Point_3 = Point;
  using Segment_3 = Kernel::Segment_3;
  using Ray_3 = Kernel::Ray_3;
  using Line_3 = Kernel::Line_3;

  struct Intersect_3 {
    CGAL::Object operator()(const ImplicitSurface& surface, const Segment_3& segment) const {
      return crossing(surface, to_eigen(segment.source()), to_eigen(segment.target()));
    }
    // Everything beyond the surface's bounding ball is irrelevant.
    CGAL::Object operator()(const ImplicitSurface& surface, const Ray_3& ray) const {
      const Eigen::Vector3d start = to_eigen(ray.source());
      return crossing(surface, start, start + beyond(surface, start) * direction(ray.to_vector()));
    }
    CGAL::Object operator()(const ImplicitSurface& surface, const Line_3& line) const {
      const Eigen::Vector3d middle = to_eigen(line.projection(to_cgal(surface.centre())));
      const Eigen::Vector3d half = beyond(surface, middle) * direction(line.to_vector());
      return crossing(surface, middle - half, middle + half);
    }
  };

  struct Construct_initial_points {
    template <typename OutputIterator>
    OutputIterator operator()(const ImplicitSurface&, OutputIterator out, int) const {
      return out;
    }
  };

  [[nodiscard]] static Intersect_3 intersect_3_object() { return {}; }
  [[nodiscard]] static Construct_initial_points construct_initial_points_object() { return {}; }

 private:
  static Eigen::Vector3d direction(const Kernel::Vector_3& v) {
    return Eigen::Vector3d(v.x(), v.y(), v.z()).normalized();
  }

  static double beyond(const ImplicitSurface& surface, const Eigen::Vector3d& point) {
    return (point - surface.centre()).norm() + surface.radius();
  }

  // Flat tetrahedra have very distant centres; the segment is first clipped to the ball.
  static CGAL::Object crossing(const ImplicitSurface& surface, Eigen::Vector3d a, Eigen::Vector3d b) {
    if ((b - surface.centre()).squaredNorm() < (a - surface.centre()).squaredNorm()) std::swap(a, b);
    const Eigen::Vector3d along = b - a;
    const double t = std::clamp(along.dot(surface.centre() - a) / along.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector3d middle = a + t * along;  // the segment's point closest to the centre of the ball
    const double reach = surface.radius() / along.norm();
    const Eigen::Vector3d from = middle - std::min(t, reach) * along;
    const Eigen::Vector3d to = middle + std::min(1 - t, reach) * along;
    const double value_from = surface(from);
    const double value_to = surface(to);
    if ((value_from < 0) == (value_to < 0)) return {};
    return CGAL::make_object(to_cgal(surface_point_between(surface, from, value_from, to, value_to)));
  }
};

// Refinement criterion: the smallest angle and the radius of the surface ball, relative to the desired size.
class FacetCriterion {
 public:
  using Quality = double;  // the worst facet, of least quality, is refined first

  FacetCriterion(const ImplicitSurface& surface, double coarseness) : surface_(&surface), coarseness_(coarseness) {}

  bool is_bad(const Triangulation::Facet& facet, Quality& quality) const {
    const auto& [cell, opposite] = facet;
    const Eigen::Vector3d a = to_eigen(cell->vertex((opposite + 1) & 3)->point());
    const Eigen::Vector3d b = to_eigen(cell->vertex((opposite + 2) & 3)->point());
    const Eigen::Vector3d c = to_eigen(cell->vertex((opposite + 3) & 3)->point());
    const Eigen::Vector3d centre = to_eigen(cell->get_facet_surface_center(opposite));
    const double size_quality = squared_size(*surface_, coarseness_, centre) / (a - centre).squaredNorm();
    const double angle_quality = squared_sine_of_min_angle(a, b, c) / squared_sine_bound;
    quality = size_quality < 1 ? size_quality : 1 + angle_quality;
    return size_quality < 1 || angle_quality < 1;
  }

 private:
  static constexpr double squared_sine_bound = 0.25;  // 30 degrees, the largest bound that surely terminates

  static double squared_sine_of_min_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                          const Eigen::Vector3d& c) {
    const double ab = (b - a).squaredNorm();
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    // The sine of an angle is twice the area over the product of its sides. The smallest angle is opposite the shortest
    // side.
    return (b - a).cross(c - a).squaredNorm() * std::min({ab, bc, ca}) / (ab * bc * ca);
  }

  const ImplicitSurface* surface_;
  double coarseness_;
};

// Finds the first point of the surface on a path outwards from `inside`.
Eigen::Vector3d way_out(const ImplicitSurface& surface, const Eigen::Vector3d& inside,
                        const Eigen::Vector3d& direction) {
  double value = surface(inside);
  const double step = std::abs(value);
  for (Eigen::Vector3d point = inside;;) {
    const Eigen::Vector3d next = point + step * direction;
    const double next_value = surface(next);
    if (next_value >= 0) return surface_point_between(surface, point, value, next, next_value);
    point = next;
    value = next_value;
  }
}

// Distributes points over the surface, outwards from every node of every limb, which covers thin parts.
std::vector<Point> seeds(const ImplicitSurface& surface, double coarseness) {
  std::vector<Eigen::Vector3d> accepted;
  for (const Eigen::Vector3d& inside : surface.inner_points()) {
    for (int i = 0; i < 6; ++i) {
      const Eigen::Vector3d direction = (i % 2 == 0 ? 1 : -1) * Eigen::Vector3d::Unit(i / 2);
      const Eigen::Vector3d point = way_out(surface, inside, direction);
      const double spacing = squared_size(surface, coarseness, point);
      bool crowded = false;
      for (const Eigen::Vector3d& other : accepted) crowded = crowded || (other - point).squaredNorm() < spacing;
      if (!crowded) accepted.push_back(point);
    }
  }
  std::vector<Point> points;
  points.reserve(accepted.size());
  for (const Eigen::Vector3d& point : accepted) points.push_back(to_cgal(point));
  return points;
}

struct TriangleSoup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> facets;
  bool is_complete = false;  // whether all points of the triangulation are in it: where not, a thin part is lost
};

// Returns the facets of the complex, in the triangulation's own order.
TriangleSoup to_soup(const SurfaceComplex& complex) {
  const Triangulation& triangulation = complex.triangulation();
  TriangleSoup soup;
  std::unordered_map<Triangulation::Vertex_handle, std::size_t> index;
  for (auto f = triangulation.finite_facets_begin(); f != triangulation.finite_facets_end(); ++f) {
    if (!complex.is_in_complex(*f)) continue;
    soup.facets.emplace_back();
    for (int k = 1; k < 4; ++k) {
      const Triangulation::Vertex_handle v = f->first->vertex((f->second + k) & 3);
      const auto [position, is_new] = index.try_emplace(v, soup.points.size());
      if (is_new) soup.points.push_back(v->point());
      soup.facets.back().push_back(position->second);
    }
  }
  soup.is_complete = soup.points.size() == triangulation.number_of_vertices();
  return soup;
}

TriangleSoup refine(const ImplicitSurface& surface, double coarseness) {
  Triangulation triangulation;
  for (const Point& point : seeds(surface, coarseness)) triangulation.insert(point);
  SurfaceComplex complex(triangulation);
  CGAL::make_surface_mesh(complex, surface, SurfaceTraits(), FacetCriterion(surface, coarseness), CGAL::Manifold_tag(),
                          0);
  return to_soup(complex);
}

// Converts the soup to a closed, connected, outward-oriented mesh; nothing if it is not one.
std::optional<Shape> closed_shape(TriangleSoup soup) {
  namespace processing = CGAL::Polygon_mesh_processing;
  if (!soup.is_complete || !processing::orient_polygon_soup(soup.points, soup.facets)) return std::nullopt;
  if (!processing::is_polygon_soup_a_polygon_mesh(soup.facets)) return std::nullopt;
  ClosedMesh mesh;
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.facets, mesh);
  if (!CGAL::is_closed(mesh)) return std::nullopt;
  auto component = mesh.add_property_map<ClosedMesh::Face_index, std::size_t>("component").first;
  if (processing::connected_components(mesh, component) != 1) return std::nullopt;
  if (!processing::is_outward_oriented(mesh)) processing::reverse_face_orientations(mesh);
  return shape_of_mesh(mesh);
}

}  // namespace

Shape mesh_implicit_surface(const ImplicitSurface& surface, int faces) {
  constexpr int attempts = 8;
  constexpr int corrections = 2;
  constexpr double trial = 0.16;
  // The number of triangles is roughly proportional to the inverse square of their size.
  const auto correction = [faces](std::size_t count) { return std::sqrt(static_cast<double>(count) / faces); };
  double coarseness = trial * correction(refine(surface, trial).facets.size());
  bool too_coarse = false;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    TriangleSoup soup = refine(surface, coarseness);
    const double factor = correction(soup.facets.size());
    if (std::optional<Shape> shape = closed_shape(std::move(soup))) {
      if (too_coarse || attempt >= corrections || std::abs(factor - 1) < 0.07) return *std::move(shape);
      coarseness *= factor;
    } else {
      too_coarse = true;
      coarseness *= 0.85;
    }
  }
  throw std::runtime_error("a generated surface cannot be meshed; raise the number of faces");
}

bool self_intersects(const Shape& mesh) {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  using Vertex = Mesh::Vertex_index;
  Mesh halfedges;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    halfedges.add_vertex({mesh.vertices(i, 0), mesh.vertices(i, 1), mesh.vertices(i, 2)});
  }
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const auto corner = [&](int k) { return Vertex(static_cast<Mesh::size_type>(mesh.triangles(f, k))); };
    halfedges.add_face(corner(0), corner(1), corner(2));
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(halfedges);
}

}  // namespace shapegauge
