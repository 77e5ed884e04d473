#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace shapegauge {

/// Signatures, one shape a row.
using Signatures = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Distances between all pairs, symmetric with zero diagonal.
using DistanceMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The names that distance_matrix understands ("l1", ...), for configurations and error messages.
std::vector<std::string> distance_names();

/// All pairwise distances of the signatures by the named distance, in parallel, the same bytes for any number of
/// threads. Throws std::invalid_argument for a name that is not in distance_names(), and for a signature with an entry
/// that is not finite, or for which the distance is not defined (distances/registry.h).
DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance = "l1");

}  // namespace shapegauge
