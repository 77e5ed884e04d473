// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/registry.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Re-ranking: unsupervised improvement of the distances between the models of a set, using the whole set. Every
/// function gives the same bytes on any number of threads. Permuting the models permutes the result, up to rounding and
/// to equal distances (ties: smaller index first).
///
/// Models at an infinite distance are not neighbours. An infinite distance stays infinite unless the two models are
/// connected through neighbours, as each method defines; it then counts as the largest finite distance of the matrix. A
/// model without neighbours therefore keeps infinite distances to all others and does not affect them. Finite distances
/// stay finite, whatever their size. The diagonal is ignored.
namespace shapegauge {

/// Option value that stands for an empty list of numbers of neighbours (neighbour_counts()).
inline constexpr std::array<std::string_view, 1> automatic_neighbours{"auto"};

/// Returns the numbers of neighbours that a re-ranking averages over, ascending. An empty list ("auto") means 4, 5, 7,
/// 10, 14 and 20.
std::vector<int> neighbour_counts(const IntegerList& neighbours);

/// Re-ranking method, an entry of the registry rerank_methods(). Functions throw InputError for settings out of range.
struct RerankMethod {
  std::string_view name;                  ///< name of the method in configurations and commands
  std::string_view description;           ///< description of the method in one sentence
  std::span<const Parameter> parameters;  ///< parameters of the method
  /// Computes the new distance matrix from a square distance matrix; required.
  DistanceMatrix (*rerank)(const DistanceMatrix&, const ParameterValues&) = nullptr;
  /// Throws InputError if parameter values contradict each other; null if they cannot.
  void (*check)(const ParameterValues&) = nullptr;
};

/// Returns the registry of re-ranking methods: those of the library (rerank.cpp), followed by those that callers add.
/// An entry must have `rerank`.
Registry<RerankMethod>& rerank_methods();

}  // namespace shapegauge
