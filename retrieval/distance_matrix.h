#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

/// Part of cache keys. To be raised with every change of a distance that changes a value.
inline constexpr int distances_version = 2;

/// Signatures, one shape a row.
using Signatures = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Distances between all pairs, symmetric with zero diagonal.
using DistanceMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// All pairwise distances of the signatures by the named distance, in parallel, the same bytes for any number of
/// threads. Throws ArgumentError for a name that is not in distances(), and for a signature with an entry
/// that is not finite, or for which the distance is not defined (DistanceDomain).
DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance = "l1");

/// Signatures that follow each other in a larger set, of which the first has the index `first`.
struct SignatureBlock {
  Eigen::Ref<const Signatures> signatures;
  Eigen::Index first = 0;
};

/// Throws ArgumentError for a signature with an entry that is not finite, or for which the distance is not
/// defined.
void check_signatures(const SignatureBlock& block, const NamedDistance& distance);

/// A part of a distance matrix: the distances from each of `some` to each of `others`, the same bits as in the whole.
/// In parallel. The signatures must have passed check_signatures().
DistanceMatrix distances_between(const NamedDistance& distance, const SignatureBlock& some,
                                 const SignatureBlock& others);

/// Streaming version of distance_matrix(): its rows from `first` on, `count` of them, the same to the bit. In parallel.
/// Throws ArgumentError as check_signatures() does, and where there are no such rows.
DistanceMatrix distance_rows(const Signatures& signatures, Eigen::Index first, Eigen::Index count,
                             const NamedDistance& distance);

}  // namespace shapegauge
