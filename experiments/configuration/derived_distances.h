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

/// Settings of a signature "sum": the weighted sum of the distance matrices of other signatures.
struct SumSettings {
  std::vector<double> weights;  ///< weight of each distance matrix in the sum, at least 0
  SumOptions options = {};      ///< normalisation and unsupervised weighting of the matrices
};

/// Settings of a signature "rerank": the re-ranked distance matrix of another signature.
struct RerankSettings {
  const RerankMethod* method;  ///< re-ranking method, one of rerank_methods(); never null
  ParameterValues values;      ///< values of the method's parameters (RerankMethod::parameters)
};

/// Distance matrix derived from those of other signatures: their weighted sum, the fusion of their ranks, or the
/// re-ranking of one of them.
struct DerivedDistances {
  std::vector<std::string> names;  ///< names of the signatures whose distances are summed, fused or re-ranked
  std::variant<SumSettings, RankFusionOptions, RerankSettings> settings;  ///< settings of the sum, fusion or re-ranking
};

/// Returns the keys that mark a signature of a configuration as derived from others: "sum", "fuse_ranks", "rerank".
std::span<const std::string_view> derived_keys();

/// Returns the parameters of signatures with derived distances: "scale" and "weights" of a "sum", "score" of
/// "fuse_ranks".
std::span<const Parameter> derived_parameters();

/// Returns the parameters of a term of "sum", apart from the name of its signature ("of").
std::span<const Parameter> sum_term_parameters();

/// Reads the derived distances of a signature from its settings. `key` is the one of derived_keys() in the settings.
/// Throws ConfigurationError if settings contradict each other.
DerivedDistances make_derived(const std::string& key, const nlohmann::json& signature);

/// Returns the key that marks derived distances in a configuration: "sum", "fuse_ranks" or "rerank".
std::string_view key_of(const DerivedDistances& derived);

/// Formats derived distances as the settings that make_derived() reads, with all defaults.
nlohmann::json to_json(const DerivedDistances& derived);

/// Computes the derived distance matrix from those of the signatures DerivedDistances::names, in the same order. Throws
/// InputError for distances that cannot be combined.
DistanceMatrix derive(const DerivedDistances& derived, std::span<const DistanceMatrix> matrices);

/// Returns a remark for users if two terms of a sum with SumWeights::agreement group the models differently
/// (find_disagreement()); otherwise an empty string. `matrices` are as in derive().
std::string remark_on(const DerivedDistances& derived, std::span<const DistanceMatrix> matrices);

}  // namespace shapegauge
