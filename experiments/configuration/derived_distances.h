// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Settings of a sum of distances.
struct SumSettings {
  std::vector<double> weights;  ///< per term
  SumOptions options = {};
};

/// Settings of a re-ranking.
struct RerankSettings {
  const RerankMethod* method;
  ParameterValues values;  ///< of its parameters
};

/// Distances derived from those of other signatures: their sum, the fusion of their ranks, or a re-ranking of one of
/// them.
struct DerivedDistances {
  std::vector<std::string> names;  ///< names of the signatures that they derive from
  std::variant<SumSettings, RankFusionOptions, RerankSettings> settings;
};

/// Returns the keys of derived distances. A signature with one of them is derived.
std::span<const std::string_view> derived_keys();

/// Returns the settings that accompany the keys: "scale" and "weights" with "sum", "score" with "fuse_ranks".
std::span<const Parameter> derived_parameters();

/// Returns the settings of a term of "sum" besides "of".
std::span<const Parameter> sum_term_parameters();

/// Reads the derived distances of a signature's settings with that key, one of derived_keys(). Throws
/// ConfigurationError if settings contradict each other.
DerivedDistances make_derived(const std::string& key, const nlohmann::json& signature);

/// Returns the key of their settings: "sum", "fuse_ranks" or "rerank".
std::string_view key_of(const DerivedDistances& derived);

/// Formats the settings as make_derived() takes them, with all defaults.
nlohmann::json to_json(const DerivedDistances& derived);

/// Computes the distances from those of the signatures that they derive from, in that order. Throws InputError for
/// distances that cannot be combined.
DistanceMatrix derive(const DerivedDistances& derived, std::span<const DistanceMatrix> matrices);

/// Returns a remark on those distances for users, or an empty string.
std::string remark_on(const DerivedDistances& derived, std::span<const DistanceMatrix> matrices);

}  // namespace shapegauge
