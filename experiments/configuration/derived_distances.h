#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/fusion.h"

namespace shapegauge {

/// Distances derived from those of other signatures: their sum, the fusion of their ranks, or a re-ranking of one of
/// them.
struct DerivedDistances {
  std::string key;                 ///< setting that defines them: "sum", "fuse_ranks" or "rerank"
  nlohmann::json settings;         ///< that setting and related ones, with all defaults
  std::vector<std::string> names;  ///< names of the signatures that they derive from
  /// Computes them from those signatures' distances, in that order. Throws InputError for distances that cannot be
  /// combined.
  std::function<DistanceMatrix(std::span<const DistanceMatrix>)> compute;
  /// Returns a remark on those distances for users, or an empty string; null for none.
  std::function<std::string(std::span<const DistanceMatrix>)> remark = {};
};

/// Settings of a sum of distances.
struct SumSettings {
  std::vector<double> weights;  ///< per term
  SumOptions options = {};
};

/// Returns the settings of derived distances whose key is "sum".
SumSettings sum_settings(const DerivedDistances& sum);

/// Returns the keys of derived distances. A signature with one of them is derived.
std::span<const std::string_view> derived_keys();

/// Returns the settings that accompany the keys: "scale" and "weights" with "sum", "score" with "fuse_ranks".
std::span<const Parameter> derived_parameters();

/// Returns the settings of a term of "sum" besides "of".
std::span<const Parameter> sum_term_parameters();

/// Makes the derived distances of a signature's settings with that key, one of derived_keys(). Throws
/// ConfigurationError if settings contradict each other.
DerivedDistances make_derived(const std::string& key, const nlohmann::json& signature);

}  // namespace shapegauge
