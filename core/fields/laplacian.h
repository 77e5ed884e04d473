#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The cotangent Laplacian of a mesh: stiffness u = lambda mass u is its eigenvalue problem (Pinkall and Polthier 1993;
/// linear finite elements). Vertices at the same place are one node; those that no triangle with area uses have none.
struct Laplacian {
  Eigen::SparseMatrix<double> stiffness;  ///< symmetric, not negative definite, rows sum to 0
  Eigen::VectorXd mass;                   ///< lumped: a third of the area of each triangle at each of its corners
  std::vector<std::int32_t> node_of;      ///< by vertex; -1: none
};

/// The Laplacian of a triangle mesh of any kind: along an edge, all of its triangles count, one (the natural, Neumann
/// boundary), two or more, doubles counted once (distinct_triangles()). The cotangents of triangles that are nearly
/// collinear are scaled down to 1e4. Throws InputError for an unusable shape (require_usable()), a point cloud, and a
/// mesh without area.
Laplacian cotangent_laplacian(const Shape& mesh);

/// The lower end of the Laplacian's spectrum.
struct Spectrum {
  Eigen::VectorXd eigenvalues;   ///< ascending, the zeros (one a component) first; one over squared length
  int components = 1;            ///< of the mesh: as many eigenvalues are 0
  Eigen::MatrixXd eigenvectors;  ///< a column an eigenvalue, at the shape's vertices; orthonormal by area; NaN at
                                 ///< vertices without a node
};

/// The `count` smallest eigenvalues with their eigenvectors, by Lanczos iteration about a shift below zero (Spectra),
/// none of them left out, multiple ones neither; fewer where there are fewer nodes. The zeros of all components count
/// as one: a mesh of c components has c - 1 eigenvalues more. The signs of eigenvectors and the
/// basis of a multiple eigenvalue are arbitrary, but the same for the same shape. Throws InputError as above, for a
/// count below 1, a mesh of more than 1,000 components, and where the iteration does not converge.
Spectrum laplacian_spectrum(const Shape& mesh, int count);

/// The same of a Laplacian that is known. Throws InputError for a count below 1, more than 1,000 components, and where
/// the iteration does not converge.
Spectrum laplacian_spectrum(const Laplacian& laplacian, int count);

}  // namespace shapegauge
