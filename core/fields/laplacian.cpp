// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/laplacian.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Spectra/SymEigsShiftSolver.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"

namespace shapegauge {

namespace {

/// Every component of a mesh adds a zero eigenvalue, and each takes time.
constexpr int max_components = 1000;

/// Contribution of a triangle.
struct Element {
  double area;
  std::array<double, 3> cotangents;  ///< of the angle at each corner
};

std::optional<Element> element_of(const Shape& mesh, Eigen::Index triangle) {
  std::array<Eigen::Vector3d, 3> corners;
  for (int k = 0; k < 3; ++k) corners[k] = mesh.vertices.row(mesh.triangles(triangle, k)).transpose();
  const double twice_area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  if (!(twice_area > 0) || !std::isnormal(twice_area)) return std::nullopt;
  Element element{twice_area / 2, {}};
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& corner = corners[k];
    element.cotangents[k] = (corners[(k + 1) % 3] - corner).dot(corners[(k + 2) % 3] - corner) / twice_area;
    largest = std::max(largest, std::abs(element.cotangents[k]));
  }
  // Scaling all three together keeps the element's energy non-negative.
  constexpr double bound = 1e4;
  for (double& cotangent : element.cotangents) cotangent *= std::min(1.0, bound / largest);
  return element;
}

using SparseMatrix = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<SparseMatrix>;

void factorise(const SparseMatrix& matrix, double shift, Cholesky& solver) {
  SparseMatrix identity(matrix.rows(), matrix.cols());
  identity.setIdentity();
  solver.compute(matrix - shift * identity);
  if (solver.info() != Eigen::Success)
    throw InputError("the mesh's Laplacian could not be factorised; repair the mesh");
}

/// y = (A - shift)^-1 x for Spectra, in the orthogonal complement of the known eigenvectors.
class ShiftedInverse {
 public:
  using Scalar = double;

  ShiftedInverse(const SparseMatrix& matrix, double shift) : size_(matrix.rows()), known_(size_, 0) {
    factorise(matrix, shift, solver_);
  }
  void set_known(const Eigen::MatrixXd& eigenvectors) { known_ = eigenvectors; }
  [[nodiscard]] Eigen::Index rows() const { return size_; }
  [[nodiscard]] Eigen::Index cols() const { return size_; }
  void set_shift(double /*shift*/) {}  // as constructed with
  void perform_op(const double* x, double* y) const {
    check_interruption();
    const Eigen::VectorXd across = without_known(Eigen::Map<const Eigen::VectorXd>(x, size_));
    Eigen::Map<Eigen::VectorXd>(y, size_) = without_known(solver_.solve(across));
  }

 private:
  [[nodiscard]] Eigen::VectorXd without_known(const Eigen::VectorXd& x) const {
    return known_.cols() == 0 ? x : Eigen::VectorXd(x - known_ * (known_.transpose() * x));
  }

  Eigen::Index size_;
  Eigen::MatrixXd known_;
  Cholesky solver_;
};

/// Eigenpairs of a symmetric matrix, ascending.
struct Eigenpairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

Eigenpairs first_of(const Eigenpairs& pairs, Eigen::Index count) {
  return {pairs.values.head(count), pairs.vectors.leftCols(count)};
}

Eigenpairs merged(const Eigenpairs& a, const Eigenpairs& b) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(a.values.size() + b.values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  Eigenpairs both{Eigen::VectorXd(std::ssize(order)), Eigen::MatrixXd(b.vectors.rows(), std::ssize(order))};
  both.values << a.values, b.values;
  both.vectors << a.vectors, b.vectors;
  std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return both.values[i]; });
  return {both.values(order), both.vectors(Eigen::all, order)};
}

/// Computes the eigenvalues next above the shift by Lanczos iteration. The start depends on the seed.
Eigenpairs iterated(ShiftedInverse& inverse, Eigen::Index count, double shift, std::uint64_t seed) {
  Spectra::SymEigsShiftSolver<ShiftedInverse> solver(inverse, count, 2 * count + 20, shift);
  RandomNumbers random(seed);
  Eigen::VectorXd start(inverse.rows());
  for (double& entry : start) entry = random.uniform(-1, 1);
  solver.init(start.data());
  constexpr Eigen::Index max_iterations = 300;
  constexpr double tolerance = 1e-9;
  try {
    solver.compute(Spectra::SortRule::LargestMagn, max_iterations, tolerance, Spectra::SortRule::SmallestAlge);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::runtime_error&) {  // Spectra's, of numbers out of range: it has no result, as below
  }
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw InputError(
        fmt::format("the {} smallest eigenvalues of the mesh's Laplacian did not converge in {} "
                    "iterations; reduce their number, or repair the mesh",
                    count, max_iterations));
  }
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// Counts the eigenvalues below a value by Sylvester's law of inertia.
Eigen::Index count_below(const SparseMatrix& matrix, double value) {
  Cholesky solver;
  factorise(matrix, value, solver);
  return (solver.vectorD().array() < 0).count();
}

/// Computes eigenpairs of a positive semidefinite matrix. Lanczos iteration may miss copies of multiple eigenvalues,
/// which symmetric shapes have. Missing ones are counted and computed in the complement of the known eigenvectors.
Eigenpairs smallest_eigenpairs(const SparseMatrix& matrix, Eigen::Index count, double shift) {
  if (matrix.rows() <= 2 * count + 20) {  // too few for Lanczos iterations
    const auto solver = eigen_decomposition(Eigen::MatrixXd(matrix));
    if (solver.info() != Eigen::Success)
      throw InputError("the eigenvalues of the mesh's Laplacian did not converge; repair the mesh");
    return first_of({solver.eigenvalues(), solver.eigenvectors()}, count);
  }
  ShiftedInverse inverse(matrix, shift);
  Eigenpairs pairs = iterated(inverse, count, shift, 0);
  constexpr int max_rounds = 20;
  for (int round = 1; round <= max_rounds; ++round) {
    const double last = pairs.values[count - 1] * (1 - 1e-6);
    const Eigen::Index missing = count_below(matrix, last) - (pairs.values.array() < last).count();
    if (missing <= 0) return pairs;
    inverse.set_known(pairs.vectors);
    // A start of its own: those missing are nearly orthogonal to the earlier ones.
    const auto seed = static_cast<std::uint64_t>(round);
    pairs = first_of(merged(pairs, iterated(inverse, std::min(missing, count), shift, seed)), count);
  }
  throw InputError(
      "the eigenvalues of the mesh's Laplacian are too close to each other to be distinguished; repair the mesh");
}

/// Returns the number of components of the mesh that the matrix belongs to.
int component_count(const SparseMatrix& matrix) {
  DisjointSets sets;
  sets.grow_to(static_cast<std::size_t>(matrix.rows()));
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      sets.join(static_cast<std::int32_t>(entry.row()), static_cast<std::int32_t>(column));
    }
  }
  int count = 0;
  for (std::int32_t i = 0; i < matrix.rows(); ++i) count += sets.find(i) == i ? 1 : 0;
  return count;
}

/// Sums the matrices of triangles. Nodes are the used welded vertices, in the order of their first triangles.
class Assembly {
 public:
  /// `welded` are welded_vertices() of the mesh.
  explicit Assembly(std::vector<std::int32_t> welded) : welded_(std::move(welded)), node_at_(welded_.size(), -1) {}

  template <typename Corners>
  void add(const Corners& vertices, const Element& element) {
    std::array<std::int32_t, 3> nodes{};
    for (int k = 0; k < 3; ++k) {
      nodes[k] = node_of(vertices[k]);
      mass_[static_cast<std::size_t>(nodes[k])] += element.area / 3;
    }
    for (int k = 0; k < 3; ++k) {
      const std::int32_t i = nodes[(k + 1) % 3];
      const std::int32_t j = nodes[(k + 2) % 3];
      const double half = element.cotangents[k] / 2;
      entries_.emplace_back(i, j, -half);
      entries_.emplace_back(j, i, -half);
      entries_.emplace_back(i, i, half);
      entries_.emplace_back(j, j, half);
    }
  }

  /// Throws InputError without triangles.
  [[nodiscard]] Laplacian laplacian() const {
    const Eigen::Index nodes = std::ssize(mass_);
    if (nodes == 0)
      throw InputError("the Laplacian needs a triangle of positive area, and the mesh has none; repair it");
    Laplacian result;
    result.stiffness.resize(nodes, nodes);
    result.stiffness.setFromTriplets(entries_.begin(), entries_.end());
    result.mass = Eigen::Map<const Eigen::VectorXd>(mass_.data(), nodes);
    for (const std::int32_t vertex : welded_) result.node_of.push_back(node_at_[static_cast<std::size_t>(vertex)]);
    return result;
  }

 private:
  std::int32_t node_of(std::int32_t vertex) {
    std::int32_t& node = node_at_[static_cast<std::size_t>(welded_[static_cast<std::size_t>(vertex)])];
    if (node < 0) {
      node = static_cast<std::int32_t>(mass_.size());
      mass_.push_back(0);
    }
    return node;
  }

  std::vector<std::int32_t> welded_;   ///< per vertex: its welded vertex
  std::vector<std::int32_t> node_at_;  ///< per welded vertex; -1 for none
  std::vector<double> mass_;           ///< per node
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace

Laplacian cotangent_laplacian(const Shape& shape) {
  require_usable(shape);
  if (is_cloud(shape))
    throw InputError("the Laplacian needs triangles, and the shape is a point cloud; use \"on\": \"proxy\"");
  const Shape mesh = without_duplicates(shape);
  Assembly assembly(welded_vertices(mesh.vertices));
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    if (const std::optional<Element> element = element_of(mesh, f)) assembly.add(mesh.triangles.row(f), *element);
  }
  return assembly.laplacian();
}

Spectrum laplacian_spectrum(const Shape& mesh, int count) {
  return laplacian_spectrum(cotangent_laplacian(mesh), count);
}

Spectrum laplacian_spectrum(const Laplacian& laplacian, int count) {
  if (count < 1) throw InputError(fmt::format("the number of eigenvalues must be at least 1, not {}", count));
  const int components = component_count(laplacian.stiffness);
  if (components > max_components) {
    throw InputError(
        fmt::format("the mesh has {} components that share no vertices; the eigenvalues of its Laplacian are supported "
                    "for at most {}; join the components, or use another descriptor",
                    components, max_components));
  }
  const Eigen::VectorXd inverse_root = laplacian.mass.cwiseSqrt().cwiseInverse();
  SparseMatrix matrix = inverse_root.asDiagonal() * laplacian.stiffness * inverse_root.asDiagonal();
  // With a total area of 1, the first non-zero eigenvalues are about 10; the shift must not be an eigenvalue.
  const double area = laplacian.mass.sum();
  matrix *= area;
  const Eigen::Index most = std::min<Eigen::Index>(components - 1 + count, matrix.rows());
  const auto [eigenvalues, eigenvectors] = smallest_eigenpairs(matrix, most, -1);
  Spectrum spectrum;
  spectrum.components = components;
  spectrum.eigenvalues = eigenvalues.cwiseMax(0) / area;
  const Eigen::MatrixXd at_nodes = inverse_root.asDiagonal() * eigenvectors;
  spectrum.eigenvectors =
      Eigen::MatrixXd::Constant(std::ssize(laplacian.node_of), most, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t v = 0; v < laplacian.node_of.size(); ++v) {
    const std::int32_t node = laplacian.node_of[v];
    if (node >= 0) spectrum.eigenvectors.row(static_cast<Eigen::Index>(v)) = at_nodes.row(node);
  }
  return spectrum;
}

}  // namespace shapegauge
