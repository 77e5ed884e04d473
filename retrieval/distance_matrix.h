#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace shapegauge {

/// To be raised with every change of a distance that changes a value: what a cache holds of earlier versions is then
/// computed anew.
inline constexpr int distances_version = 2;

/// Signatures, one shape a row.
using Signatures = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Distances between all pairs, symmetric with zero diagonal.
using DistanceMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The names that distance_matrix understands ("l1", ...), for configurations and error messages.
std::vector<std::string> distance_names();

/// All pairwise distances of the signatures by the named distance, in parallel, the same bytes for any number of
/// threads. Throws std::invalid_argument for a name that is not in distance_names(), and for a signature with an entry
/// that is not finite.
DistanceMatrix distance_matrix(const Signatures& signatures, const std::string& distance = "l1");

/// Some of the matrix's rows, `count` from `first` on, bit by bit: for sets of signatures too large for all of it. In
/// parallel; throws as distance_matrix does, and where there are no such rows.
DistanceMatrix distance_rows(const Signatures& signatures, Eigen::Index first, Eigen::Index count,
                             const std::string& distance = "l1");

}  // namespace shapegauge
