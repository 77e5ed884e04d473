#include "shapegauge/experiments/generator/bone_weights.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace shapegauge {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

// The cotangent Laplacian (positive semi-definite) and, in `areas`, a third of the area around every vertex.
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

}  // namespace shapegauge
