// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of shape_dna().
struct ShapeDnaOptions {
  int eigenvalues = 20;        ///< number of positive eigenvalues; the SHREC'11 entry used 12
  bool divide_by_rank = true;  ///< divide the k-th eigenvalue by k, which equalises their effect; false as published
};

/// Computes ShapeDNA (Reuter, Wolter, Peinecke 2006): the first positive eigenvalues of the surface's Laplacian, times
/// its area over 4 pi. In these units the k-th eigenvalue tends to k (Weyl). Eigenvalues are invariant to isometric
/// bending. Zero eigenvalues, one for each component, are omitted. Meshes with fewer vertices are padded with zeros.
/// Compared by L2.
///
/// For a sphere the eigenvalues are l (l + 1), with multiplicity 2 l + 1. Throws InputError for options out of range
/// and as laplacian_spectrum() does: for clouds and if the iteration does not converge.
Eigen::VectorXf shape_dna(const Shape& mesh, const ShapeDnaOptions& options = {});

/// Computes ShapeDNA on the surface proxy of any shape. Throws InputError for options out of range and as
/// surface_proxy() does.
Eigen::VectorXf shape_dna_on_proxy(ProxySource& source, const ShapeDnaOptions& options = {});

/// Returns the entry "shape_dna" of the registry descriptors().
Descriptor shape_dna_descriptor();

}  // namespace shapegauge
