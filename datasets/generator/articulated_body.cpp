// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/articulated_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "shapegauge/datasets/generator/implicit_surface.h"
#include "shapegauge/datasets/generator/mesh_implicit_surface.h"

namespace shapegauge {

namespace {

/// Returns true if a triangle is a thousand times longer than high.
bool has_degenerate_triangle(const Shape& shape) {
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(f, 2));
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if ((b - a).cross(c - a).norm() <= 1e-3 * longest) return true;
  }
  return false;
}

}  // namespace

ArticulatedBody make_articulated_body(const Skeleton& skeleton, int faces) {
  const ImplicitSurface surface(skeleton);
  const Shape mesh = mesh_implicit_surface(surface, faces);
  ArticulatedBody body;
  body.skeleton = skeleton;
  body.rest = {mesh.vertices, bone_tree_of(skeleton)};
  body.triangles = mesh.triangles;
  body.weights = bone_weights(mesh, surface, body.rest.tree);
  body.labels = limb_labels(mesh, body.weights, body.rest.tree);
  return body;
}

Shape draw_model(const ArticulatedBody& body, RandomNumbers& random) {
  constexpr int attempts = 60;
  constexpr double shrinkage = 0.96;
  const RestPose individual = draw_individual(body.skeleton, body.rest, body.weights, random);
  double amplitude = 1;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const std::vector<RigidMotion> motions = draw_pose(body.skeleton, individual.tree, amplitude, random);
    Shape model{skin_points(individual.points, body.weights, motions), body.triangles};
    if (!has_degenerate_triangle(model) && !self_intersects(model)) return model;
    amplitude *= shrinkage;
  }
  throw std::runtime_error("no pose of the generated class " + body.skeleton.name + " is free of self-intersections");
}

}  // namespace shapegauge
