// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/doubled_shapes.h"

#include <cmath>
#include <numeric>
#include <ostream>
#include <utility>

#include "tests/support/test_shapes.h"

namespace shapegauge::test {

namespace {

struct Doubling {
  std::string name;
  int copies = 1;                  ///< of each triangle that is doubled, besides itself
  int every = 1;                   ///< which triangles are doubled
  bool turned = false;             ///< whether the copies are oriented the other way
  bool separate_vertices = false;  ///< whether no copy shares vertices with its triangle
  bool between = false;            ///< whether copies follow their triangle at once, not all after the last one
};

/// Adds a copy of triangle f that begins at another corner.
void add_copy(ShapeWithDuplicates& doubled, const Shape& mesh, Eigen::Index f, const Doubling& doubling) {
  Eigen::RowVector3i corners(mesh.triangles(f, 1), mesh.triangles(f, 2), mesh.triangles(f, 0));
  if (doubling.turned) std::swap(corners[0], corners[1]);
  Shape& shape = doubled.shape;
  if (doubling.separate_vertices) {
    for (std::int32_t& vertex : corners) {
      shape.vertices.conservativeResize(shape.vertices.rows() + 1, Eigen::NoChange);
      shape.vertices.bottomRows<1>() = mesh.vertices.row(vertex);
      doubled.vertices.push_back(vertex);
      vertex = static_cast<std::int32_t>(shape.vertices.rows() - 1);
    }
  }
  shape.triangles.conservativeResize(shape.triangles.rows() + 1, Eigen::NoChange);
  shape.triangles.bottomRows<1>() = corners;
  doubled.triangles.push_back(static_cast<std::int32_t>(f));
}

ShapeWithDuplicates doubled(const Shape& mesh, const Doubling& doubling) {
  ShapeWithDuplicates result{
      .name = doubling.name, .shape = {mesh.vertices, Triangles(0, 3)}, .triangles = {}, .vertices = {}};
  result.vertices.resize(static_cast<std::size_t>(mesh.vertices.rows()));
  std::iota(result.vertices.begin(), result.vertices.end(), 0);
  const auto add_copies = [&](Eigen::Index f) {
    for (int copy = 0; copy < doubling.copies && f % doubling.every == 0; ++copy) add_copy(result, mesh, f, doubling);
  };
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    result.shape.triangles.conservativeResize(result.shape.triangles.rows() + 1, Eigen::NoChange);
    result.shape.triangles.bottomRows<1>() = mesh.triangles.row(f);
    result.triangles.push_back(static_cast<std::int32_t>(f));
    if (doubling.between) add_copies(f);
  }
  for (Eigen::Index f = 0; f < mesh.triangles.rows() && !doubling.between; ++f) add_copies(f);
  return result;
}

/// A bumpy ball, open at the bottom, with two small holes.
Shape open_ball() {
  Shape ball = sphere(1, 3);
  for (auto vertex : ball.vertices.rowwise()) {
    vertex *= 1 + 0.15 * std::sin(3 * vertex.x() + 1) * std::cos(4 * vertex.y()) + 0.05 * std::sin(5 * vertex.z());
  }
  Shape open{ball.vertices, Triangles(0, 3)};
  std::vector<Eigen::Index> remaining;
  for (Eigen::Index f = 0; f < ball.triangles.rows(); ++f) {
    const Eigen::RowVector3d middle = ball.vertices(ball.triangles.row(f), Eigen::all).colwise().mean();
    const bool is_hole = (middle - Eigen::RowVector3d(0.9, 0.3, 0.2)).norm() < 0.2 ||
                         (middle - Eigen::RowVector3d(-0.5, -0.8, 0.3)).norm() < 0.15;
    if (middle.z() > -0.85 && !is_hole) remaining.push_back(f);
  }
  open.triangles = ball.triangles(remaining, Eigen::all);
  return open;
}

/// A box with a wall across its middle, attached at edges with three triangles each.
Shape box_with_wall() {
  Shape shape = box({1, 1.3, 0.8}, 4);
  Shape wall = box({1, 1.3, 0.8}, 4);
  std::vector<Eigen::Index> side;
  for (Eigen::Index f = 0; f < wall.triangles.rows(); ++f) {
    if ((wall.vertices(wall.triangles.row(f), 0).array() == 0.5).all()) side.push_back(f);
  }
  wall.triangles = wall.triangles(side, Eigen::all).eval();
  wall.vertices.col(0).setZero();
  return joined({shape, wall});
}

}  // namespace

std::vector<ShapeWithDuplicates> variants_with_duplicates(const Shape& mesh) {
  std::vector<ShapeWithDuplicates> all;
  for (const Doubling& doubling :
       {Doubling{.name = "doubled"}, Doubling{.name = "tripled", .copies = 2},
        Doubling{.name = "doubled between", .between = true}, Doubling{.name = "doubled, turned", .turned = true},
        Doubling{.name = "tripled, turned", .copies = 2, .turned = true, .between = true},
        Doubling{.name = "doubled, own vertices", .separate_vertices = true},
        Doubling{.name = "tripled, turned, own vertices", .copies = 2, .turned = true, .separate_vertices = true},
        Doubling{
            .name = "every third doubled, own vertices", .every = 3, .separate_vertices = true, .between = true}}) {
    all.push_back(doubled(mesh, doubling));
  }
  return all;
}

void PrintTo(const NamedShape& named, std::ostream* stream) { *stream << named.name; }

std::vector<NamedShape> shapes_without_duplicates() {
  return {{"torus", torus(1, 0.35, 16, 24)},
          {"open ball", open_ball()},
          {"box with a wall", box_with_wall()},
          {"soup", soup(capsule(0.3, 1, 14, 5))}};
}

}  // namespace shapegauge::test
