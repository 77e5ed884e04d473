// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/io/random_shapes.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "shapegauge/core/io/triangulate_polygon.h"

namespace shapegauge::test {

rc::Gen<double> any_finite() {
  const auto any_bits = rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()),
                                     [](std::uint64_t bits) { return std::bit_cast<double>(bits); });
  return rc::gen::suchThat(rc::gen::oneOf(any_bits, rc::gen::arbitrary<double>()),
                           [](double x) { return std::isfinite(x); });
}

rc::Gen<Polygons> any_polygons(bool triangles_only) {
  return rc::gen::exec([triangles_only] {
    Polygons polygons;
    const auto points = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::array<double, 3>>>(
        rc::gen::container<std::array<double, 3>>(any_finite())));
    polygons.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        polygons.vertices(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = points[i][k];
      }
    }
    const auto index = rc::gen::inRange<std::int32_t>(0, static_cast<std::int32_t>(points.size()));
    const auto face = rc::gen::mapcat(rc::gen::inRange<std::size_t>(3, triangles_only ? 4 : 7), [index](std::size_t n) {
      return rc::gen::container<std::vector<std::int32_t>>(n, index);
    });
    polygons.faces = *rc::gen::container<std::vector<std::vector<std::int32_t>>>(face);
    return polygons;
  });
}

Shape shape_of(const Polygons& polygons) {
  std::vector<std::array<std::int32_t, 3>> triangles;
  for (const auto& face : polygons.faces) {
    std::vector<Eigen::Vector3d> corners;
    for (const std::int32_t corner : face) corners.emplace_back(polygons.vertices.row(corner));
    std::vector<PolygonTriangle> of_face = triangles_in_place_of_fan(corners);
    const bool fan = of_face.empty();
    for (std::int32_t k = 2; fan && k < static_cast<std::int32_t>(face.size()); ++k) of_face.push_back({0, k - 1, k});
    for (const auto& [a, b, c] : of_face) {
      triangles.push_back(
          {face[static_cast<std::size_t>(a)], face[static_cast<std::size_t>(b)], face[static_cast<std::size_t>(c)]});
    }
  }
  Shape shape{polygons.vertices, Triangles(static_cast<Eigen::Index>(triangles.size()), 3)};
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      shape.triangles(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)) = triangles[f][k];
    }
  }
  return shape;
}

}  // namespace shapegauge::test
