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

/// Distances that are made from the distances of other signatures: their sum, the fusion of their ranks, or one of
/// them re-ranked.
struct DerivedDistances {
  std::string key;                 ///< the setting that asks for them: "sum", "fuse_ranks" or "rerank"
  nlohmann::json settings;         ///< that setting and those that go with it, defaults filled in
  std::vector<std::string> names;  ///< of the signatures that they are made from
  /// From those signatures' distances, in that order. Throws InputError for distances that
  /// cannot be combined.
  std::function<DistanceMatrix(std::span<const DistanceMatrix>)> compute;
};

/// The settings of a sum of distances.
struct SumSettings {
  std::vector<double> weights;  ///< by term
  SumWeights kind = SumWeights::given;
  DistanceScale scale = DistanceScale::median;
};

/// The settings of derived distances whose key is "sum".
SumSettings sum_settings(const DerivedDistances& sum);

/// The settings that ask for derived distances, by each of which a signature is of that kind.
std::span<const std::string_view> derived_keys();

/// The settings that go with one of them: "scale" and "weights" with "sum", "score" with "fuse_ranks".
std::span<const Parameter> derived_parameters();

/// The settings of a term of "sum" besides "of".
std::span<const Parameter> sum_term_parameters();

/// The derived distances of a signature's settings that have the key, one of derived_keys(). Throws ConfigurationError
/// for settings that contradict each other.
DerivedDistances make_derived(const std::string& key, const nlohmann::json& signature);

}  // namespace shapegauge
