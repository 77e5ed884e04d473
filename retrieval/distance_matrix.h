// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "shapegauge/core/base/distance_rows.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

/// Cache version of distances between signatures, to increment when they change; see docs/manual/cache.md.
inline constexpr int distances_version = 2;

/// Signatures (feature vectors) of shapes, one row per shape.
using Signatures = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Computes all pairwise distances of signatures by the named distance: a symmetric matrix with zero diagonal.
/// Parallel, with the same bytes for any number of threads. Throws ArgumentError for a name that is not in distances(),
/// for an entry that is not finite, and for a signature outside the distance's domain (DistanceDomain).
DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance = "l1");
/// Computes all pairwise distances of signatures by a distance that need not be in the registry distances().
DistanceMatrix distance_matrix(const Signatures& signatures, const NamedDistance& distance);

/// Consecutive signatures of a larger set.
struct SignatureBlock {
  Eigen::Ref<const Signatures> signatures;  ///< signatures of the block, one per row
  Eigen::Index first = 0;                   ///< index of the block's first signature in the set
};

/// Throws ArgumentError for a signature with an entry that is not finite, or outside the distance's domain.
void check_signatures(const SignatureBlock& block, const NamedDistance& distance);

/// Computes a block of a distance matrix: the distance from each signature of `some` (rows) to each of `others`
/// (columns). Equal to the block of the whole distance_matrix() to the bit. Parallel. The signatures must have passed
/// check_signatures().
DistanceMatrix distances_between(const NamedDistance& distance, const SignatureBlock& some,
                                 const SignatureBlock& others);

/// Streaming version of distance_matrix(): computes `count` rows from row `first` on, bit-identical. Parallel. Throws
/// ArgumentError as check_signatures() does, and for rows out of range.
DistanceMatrix distance_rows(const Signatures& signatures, Eigen::Index first, Eigen::Index count,
                             const NamedDistance& distance);

}  // namespace shapegauge
