#include "shapegauge/core/perturbation/decimation_module.h"

#include <algorithm>

namespace shapegauge {

namespace {

using Vector = DecimationMesh::Point;
using OpenMesh::Geometry::Quadricd;

/// Weight of the planes on open edges against those of the faces.
constexpr double open_edge_weight = 10;

Quadricd plane_quadric(const Vector& unit_normal, const Vector& point, double weight) {
  return Quadricd(unit_normal[0], unit_normal[1], unit_normal[2], -unit_normal.dot(point)) * weight;
}

/// Twice the area over the square of the longest side: 0 for a degenerate triangle, 0.87 for an equilateral one.
double roundness(const Vector& a, const Vector& b, const Vector& c) {
  const double longest = std::max({(b - a).sqrnorm(), (c - b).sqrnorm(), (a - c).sqrnorm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

}  // namespace

const std::string& DecimationModule::name() const {
  static const std::string text = "quadric error without flipped faces";
  return text;
}

void DecimationModule::initialize() {
  quadrics_.assign(mesh().n_vertices(), Quadricd());
  for (const auto face : mesh().faces()) {
    auto side = mesh().halfedge_handle(face);
    const Vector a = mesh().point(mesh().from_vertex_handle(side));
    const Vector b = mesh().point(mesh().to_vertex_handle(side));
    const Vector c = mesh().point(mesh().to_vertex_handle(mesh().next_halfedge_handle(side)));
    const Vector cross = (b - a).cross(c - a);
    const double twice_area = cross.norm();
    if (!(twice_area > 0)) continue;
    const Vector normal = cross / twice_area;
    for (int k = 0; k < 3; ++k, side = mesh().next_halfedge_handle(side)) {
      const auto from = mesh().from_vertex_handle(side);
      const auto to = mesh().to_vertex_handle(side);
      quadrics_[static_cast<std::size_t>(from.idx())] += plane_quadric(normal, a, twice_area / 2);
      if (!mesh().is_boundary(mesh().opposite_halfedge_handle(side))) continue;
      const Vector edge = mesh().point(to) - mesh().point(from);
      const Quadricd wall =
          plane_quadric(normal.cross(edge).normalized(), mesh().point(from), open_edge_weight * edge.sqrnorm());
      for (const auto end : {from, to}) quadrics_[static_cast<std::size_t>(end.idx())] += wall;
    }
  }
}

bool DecimationModule::keeps_faces(const CollapseInfo& collapse) {
  constexpr double least_cosine = 0.17;  // 80 degrees
  constexpr double least_roundness = 0.02;
  for (const auto side : mesh().voh_range(collapse.v0)) {
    if (mesh().is_boundary(side)) continue;
    const auto second = mesh().to_vertex_handle(side);
    const auto third = mesh().to_vertex_handle(mesh().next_halfedge_handle(side));
    if (second == collapse.v1 || third == collapse.v1) continue;  // a face that goes
    const Vector b = mesh().point(second);
    const Vector c = mesh().point(third);
    const double before_roundness = roundness(collapse.p0, b, c);
    if (roundness(collapse.p1, b, c) < std::min(least_roundness, before_roundness)) return false;
    const Vector before = (b - collapse.p0).cross(c - collapse.p0);
    const Vector after = (b - collapse.p1).cross(c - collapse.p1);
    if (before_roundness > 0 && before.dot(after) < least_cosine * before.norm() * after.norm()) return false;
  }
  return true;
}

float DecimationModule::collapse_priority(const CollapseInfo& collapse) {
  if (!keeps_faces(collapse)) return ILLEGAL_COLLAPSE;
  const Quadricd sum =
      quadrics_[static_cast<std::size_t>(collapse.v0.idx())] + quadrics_[static_cast<std::size_t>(collapse.v1.idx())];
  return static_cast<float>(std::max(0.0, sum(collapse.p1)));
}

void DecimationModule::postprocess_collapse(const CollapseInfo& collapse) {
  quadrics_[static_cast<std::size_t>(collapse.v1.idx())] += quadrics_[static_cast<std::size_t>(collapse.v0.idx())];
}

}  // namespace shapegauge
