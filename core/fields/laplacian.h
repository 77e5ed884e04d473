// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cotangent Laplacian of a mesh, for the eigenvalue problem stiffness u = lambda mass u (Pinkall and Polthier 1993;
/// linear finite elements). Coincident vertices share a node; vertices that no triangle with area uses have none.
struct Laplacian {
  Eigen::SparseMatrix<double> stiffness;  ///< one row per node; symmetric, positive semidefinite, rows sum to 0
  Eigen::VectorXd mass;                   ///< lumped mass of each node: a third of the area of its triangles
  std::vector<std::int32_t> node_of;      ///< per vertex of the mesh: index of its node; -1 without a node
};

/// Assembles the Laplacian of a triangle mesh of any kind. All triangles at an edge contribute: one (the natural,
/// Neumann boundary), two or more, with duplicates counted once (distinct_triangles()). Cotangents of nearly degenerate
/// triangles are limited to 1e4. Throws InputError for an unusable shape (require_usable()), a point cloud, and a mesh
/// without area.
Laplacian cotangent_laplacian(const Shape& mesh);

/// Smallest eigenvalues of a mesh's Laplacian and their eigenvectors.
struct Spectrum {
  Eigen::VectorXd eigenvalues;  ///< ascending, beginning with one zero per component; unit: 1 / squared length
  int components = 1;           ///< number of components of the mesh, which is also the number of zero eigenvalues
  /// One column per eigenvalue, one row per vertex; orthonormal by area; NaN at vertices without a node
  /// (Laplacian::node_of).
  Eigen::MatrixXd eigenvectors;
};

/// Computes the `count` smallest eigenvalues, complete and with multiplicity, and their eigenvectors, by Lanczos
/// iteration about a shift below zero (Spectra). Returns fewer if there are fewer nodes. The zeros of all components
/// count as one: a mesh of c components has c - 1 additional eigenvalues. Signs of eigenvectors and bases of multiple
/// eigenvalues are arbitrary but deterministic. Throws InputError as cotangent_laplacian() does, for a count below 1,
/// for a mesh of more than 1,000 components, and if the iteration does not converge.
Spectrum laplacian_spectrum(const Shape& mesh, int count);

/// Computes the `count` smallest eigenvalues of an existing Laplacian and their eigenvectors. Throws InputError for a
/// count below 1, more than 1,000 components, and if the iteration does not converge.
Spectrum laplacian_spectrum(const Laplacian& laplacian, int count);

}  // namespace shapegauge
