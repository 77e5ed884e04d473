// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/pose.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>

namespace shapegauge {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

// Computes the cotangent Laplacian (positive semidefinite) and, in `areas`, a third of the area around every vertex.
SparseMatrix laplacian(const Shape& mesh, Eigen::VectorXd& areas) {
  areas = Eigen::VectorXd::Zero(mesh.vertices.rows());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(f, k);
      const int b = mesh.triangles(f, (k + 1) % 3);
      const int c = mesh.triangles(f, (k + 2) % 3);
      const Eigen::Vector3d u = mesh.vertices.row(a) - mesh.vertices.row(c);
      const Eigen::Vector3d v = mesh.vertices.row(b) - mesh.vertices.row(c);
      const double twice_area = u.cross(v).norm();
      const double half_cotangent = 0.5 * u.dot(v) / twice_area;
      areas[c] += twice_area / 6;
      entries.insert(
          entries.end(),
          {{a, b, -half_cotangent}, {b, a, -half_cotangent}, {a, a, half_cotangent}, {b, b, half_cotangent}});
    }
  }
  SparseMatrix matrix(mesh.vertices.rows(), mesh.vertices.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Bend of a limb that curls: for each of its hinges a number in [-1, 1] at the limb's root and one at its tip.
struct Curl {
  std::vector<double> at_root, at_tip;
};

double angle_within(const Hinge& hinge, double fraction, double amplitude) {
  return amplitude * (0.5 * (hinge.lower + hinge.upper) + 0.5 * fraction * (hinge.upper - hinge.lower));
}

std::vector<int> bone_counts(const BoneTree& tree) {
  std::vector<int> counts(tree.bone_of_segment.size());
  for (const Bone& bone : tree.bones) ++counts[static_cast<std::size_t>(bone.limb)];
  return counts;
}

// Draws a number in [-1, 1] for one hinge of a bone: independent, or close to that of the limb's smooth bend.
double draw_fraction(bool curls, Curl& curl, std::size_t hinge, double position, RandomNumbers& random) {
  if (!curls) return random.uniform(-1, 1);
  while (curl.at_root.size() <= hinge) {
    curl.at_root.push_back(random.uniform(-1, 1));
    curl.at_tip.push_back(random.uniform(-1, 1));
  }
  const double common = (1 - position) * curl.at_root[hinge] + position * curl.at_tip[hinge];
  return 0.85 * common + 0.15 * random.uniform(-1, 1);
}

constexpr double largest_deviation = 0.07;

struct Growth {
  double length = 1;
  double girth = 1;
};

std::map<std::string, Growth> draw_growth(const Skeleton& skeleton, RandomNumbers& random) {
  std::map<std::string, Growth> growth;
  for (const Limb& limb : skeleton.limbs) {
    const auto [position, is_new] = growth.try_emplace(limb.kind);
    if (!is_new) continue;
    position->second.length = random.uniform(1 - largest_deviation, 1 + largest_deviation);
    position->second.girth = random.uniform(1 - largest_deviation, 1 + largest_deviation);
  }
  return growth;
}

// Computes the map of every bone's surroundings: stretched along and around the bone, and moved with the bone's parent.
std::vector<Eigen::Affine3d> bone_maps(const Skeleton& skeleton, const BoneTree& tree, RandomNumbers& random) {
  const std::map<std::string, Growth> growth = draw_growth(skeleton, random);
  std::vector<Eigen::Affine3d> maps;
  for (const Bone& bone : tree.bones) {
    const Growth& factors = growth.at(skeleton.limbs[static_cast<std::size_t>(bone.limb)].kind);
    const Eigen::Vector3d start =
        bone.parent < 0 ? bone.joint : maps[static_cast<std::size_t>(bone.parent)] * bone.joint;
    const Eigen::Matrix3d along = bone.direction * bone.direction.transpose();
    const Eigen::Matrix3d stretch = factors.length * along + factors.girth * (Eigen::Matrix3d::Identity() - along);
    maps.emplace_back(Eigen::Translation3d(start) * stretch * Eigen::Translation3d(-bone.joint));
  }
  return maps;
}

}  // namespace

Eigen::MatrixXd bone_weights(const Shape& mesh, const ImplicitSurface& surface, const BoneTree& tree) {
  // Solves -laplacian(w) + h w = h p for every bone's w, with p = 1 where the bone is the nearest one, and h = 1/r^2.
  Eigen::VectorXd areas;
  SparseMatrix system = laplacian(mesh, areas);
  Eigen::MatrixXd sources = Eigen::MatrixXd::Zero(mesh.vertices.rows(), static_cast<Eigen::Index>(tree.bones.size()));
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const ImplicitSurface::Nearest nearest = surface.nearest_limb(mesh.vertices.row(i).transpose());
    const double heat = areas[i] / (nearest.radius * nearest.radius);
    const auto& of_segment = tree.bone_of_segment[static_cast<std::size_t>(nearest.limb)];
    system.coeffRef(i, i) += heat;
    sources(i, of_segment[static_cast<std::size_t>(nearest.segment)]) = heat;
  }
  const Eigen::SimplicialLDLT<SparseMatrix> solver(system);
  if (solver.info() != Eigen::Success) throw std::runtime_error("the bone weights of a generated mesh cannot be found");
  Eigen::MatrixXd weights = solver.solve(sources).cwiseMax(0);  // obtuse triangles may give slightly negative ones
  weights.array().colwise() /= weights.rowwise().sum().array();
  return weights;
}

Eigen::VectorXi limb_labels(const Shape& mesh, const Eigen::MatrixXd& weights, const BoneTree& tree) {
  const auto limbs = static_cast<Eigen::Index>(tree.bone_of_segment.size());
  Eigen::MatrixXd of_limb = Eigen::MatrixXd::Zero(weights.rows(), limbs);
  for (std::size_t b = 0; b < tree.bones.size(); ++b) {
    of_limb.col(tree.bones[b].limb) += weights.col(static_cast<Eigen::Index>(b));
  }
  Eigen::VectorXi labels(mesh.triangles.rows());
  for (Eigen::Index f = 0; f < labels.size(); ++f) {
    const Eigen::VectorXd sum =
        of_limb.row(mesh.triangles(f, 0)) + of_limb.row(mesh.triangles(f, 1)) + of_limb.row(mesh.triangles(f, 2));
    sum.maxCoeff(&labels[f]);
  }
  return labels;
}

std::vector<RigidMotion> draw_pose(const Skeleton& skeleton, const BoneTree& tree, double amplitude,
                                   RandomNumbers& random) {
  const std::vector<int> counts = bone_counts(tree);
  std::vector<Curl> curls(skeleton.limbs.size());
  std::vector<RigidMotion> motions;
  for (const Bone& bone : tree.bones) {
    const auto limb = static_cast<std::size_t>(bone.limb);
    const double position = static_cast<double>(bone.index_in_limb) / std::max(1, counts[limb] - 1);
    RigidMotion motion = bone.parent < 0 ? RigidMotion() : motions[static_cast<std::size_t>(bone.parent)];
    const Eigen::Vector3d joint = motion.rotation * bone.joint + motion.translation;
    for (std::size_t h = 0; h < bone.hinges.size(); ++h) {
      const double fraction = draw_fraction(skeleton.limbs[limb].curls, curls[limb], h, position, random);
      const double angle = angle_within(bone.hinges[h], fraction, amplitude);
      motion.rotation = motion.rotation * Eigen::AngleAxisd(angle, bone.hinges[h].axis);
    }
    motion.translation = joint - motion.rotation * bone.joint;
    motions.push_back(motion);
  }
  return motions;
}

Points skin_points(const Points& points, const Eigen::MatrixXd& weights, const std::vector<RigidMotion>& motions) {
  // The dual part of a motion's quaternion is half of translation times rotation.
  const auto bones = static_cast<Eigen::Index>(motions.size());
  Eigen::Matrix<double, Eigen::Dynamic, 8> motion_rows(bones, 8);
  for (Eigen::Index b = 0; b < bones; ++b) {
    const RigidMotion& motion = motions[static_cast<std::size_t>(b)];
    const Eigen::Vector3d half = 0.5 * motion.translation;
    const Eigen::Quaterniond dual = Eigen::Quaterniond(0, half.x(), half.y(), half.z()) * motion.rotation;
    motion_rows.row(b) << motion.rotation.coeffs().transpose(), dual.coeffs().transpose();
  }
  // A motion and its negative are equal; by construction those of a parent and its child have the same sign.
  const Eigen::Matrix<double, Eigen::Dynamic, 8> blended = weights * motion_rows;
  Points result(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double norm = blended.row(i).head<4>().norm();
    const Eigen::Quaterniond real(Eigen::Vector4d(blended.row(i).head<4>().transpose() / norm));
    const Eigen::Quaterniond dual(Eigen::Vector4d(blended.row(i).tail<4>().transpose() / norm));
    const Eigen::Vector3d translation = 2 * (dual * real.conjugate()).vec();
    const Eigen::Vector3d point = points.row(i);
    result.row(i) = (real * point + translation).transpose();
  }
  return result;
}

RestPose draw_individual(const Skeleton& skeleton, const RestPose& rest, const Eigen::MatrixXd& weights,
                         RandomNumbers& random) {
  const std::vector<Eigen::Affine3d> maps = bone_maps(skeleton, rest.tree, random);
  RestPose result = rest;
  result.points.setZero();
  for (std::size_t b = 0; b < maps.size(); ++b) {
    const Points moved = (rest.points * maps[b].linear().transpose()).rowwise() + maps[b].translation().transpose();
    result.points += weights.col(static_cast<Eigen::Index>(b)).asDiagonal() * moved;
    result.tree.bones[b].joint = maps[b] * rest.tree.bones[b].joint;
  }
  return result;
}

}  // namespace shapegauge
