#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// To be raised with every change of shape_dna() that changes a value.
inline constexpr int shape_dna_version = 3;

/// Settings of shape_dna().
struct ShapeDnaOptions {
  int eigenvalues = 20;        ///< positive ones; SHREC'11's entry took 12
  bool divide_by_rank = true;  ///< the k-th divided by k, so that each counts alike; as published: false
};

/// ShapeDNA (Reuter, Wolter, Peinecke 2006): the first positive eigenvalues of the surface's Laplacian, times its area
/// over 4 pi, in which units the k-th tends to k (Weyl). They do not change when the surface bends. The zeros, one for
/// each component, are left out. Meshes with fewer vertices end with zeros. Compared by L2.
///
/// The sphere's are l (l + 1), each 2 l + 1 times. Throws InputError for options out of range and as
/// laplacian_spectrum(): for clouds and where the eigenvalues do not converge.
Eigen::VectorXf shape_dna(const Shape& mesh, const ShapeDnaOptions& options = {});

/// The same on the surface proxy of any shape. Throws InputError for options out of range and as surface_proxy().
Eigen::VectorXf shape_dna_on_proxy(ProxySource& source, const ShapeDnaOptions& options = {});

Descriptor shape_dna_descriptor();

}  // namespace shapegauge
