// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/cavities.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"

namespace shapegauge {

namespace {

/// Connected component of a closed mesh.
struct ClosedPart {
  double six_volumes = 0;  ///< negative where it is oriented inwards
  Eigen::AlignedBox3d box;
};

std::vector<ClosedPart> closed_parts(const Shape& shape) {
  const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
  DisjointSets sets;
  sets.grow_to(merged.size());
  const auto vertex = [&](Eigen::Index f, int k) { return merged[static_cast<std::size_t>(shape.triangles(f, k))]; };
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    sets.join(vertex(f, 0), vertex(f, 1));
    sets.join(vertex(f, 0), vertex(f, 2));
  }
  const Eigen::Vector3d centre = bounding_box(shape).center();
  std::map<std::int32_t, ClosedPart> parts;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    ClosedPart& part = parts[sets.find(vertex(f, 0))];
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return shape.vertices.row(shape.triangles(f, k)).transpose() - centre;
    };
    part.six_volumes += corner(0).dot(corner(1).cross(corner(2)));
    for (int k = 0; k < 3; ++k) part.box.extend(corner(k));
  }
  std::vector<ClosedPart> result;
  for (const auto& [vertex_of_part, part] : parts) result.push_back(part);
  return result;
}

}  // namespace

ClosedComponents closed_components(const Shape& original) {
  require_usable(original);
  const Shape shape = without_duplicates(original);
  if (is_cloud(shape) || !is_closed_and_oriented(shape)) return {};
  const std::vector<ClosedPart> parts = closed_parts(shape);
  const auto size = [](const ClosedPart& part) { return std::abs(part.six_volumes); };
  const double largest = std::ranges::max_element(parts, {}, size)->six_volumes;
  const auto is_reversed = [&](const ClosedPart& part) { return part.six_volumes * largest < 0; };
  const auto is_cavity = [&](const ClosedPart& part) {
    return is_reversed(part) && std::ranges::any_of(parts, [&](const ClosedPart& other) {
             return other.six_volumes * largest > 0 && size(other) > size(part) && other.box.contains(part.box);
           });
  };
  ClosedComponents components;
  double six_volumes = 0;
  for (const ClosedPart& part : parts) {
    const bool cavity = is_cavity(part);
    if (cavity) ++components.cavities;
    if (is_reversed(part) && !cavity) ++components.reversed;
    six_volumes += cavity ? -size(part) : size(part);
  }
  components.volume = six_volumes / 6;
  return components;
}

}  // namespace shapegauge
