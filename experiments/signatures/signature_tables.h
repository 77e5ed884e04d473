// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"
#include "shapegauge/retrieval/histogram.h"

/// Tables of signatures, assembled from the descriptions of models.

namespace shapegauge {

/// Returns the distance between signatures of a kind that is not derived: a descriptor's own, or the configuration's.
NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration);

/// Maximum number of models of a cached distance matrix: 64 MB. A larger one is computed as fast as it is read.
inline constexpr Eigen::Index max_models_of_cached_distances = 2900;

/// Computes distance_matrix() or reads it from the cache; stores it there, for up to max_models_of_cached_distances
/// signatures. Throws as distance_matrix() does.
DistanceMatrix distances_through_cache(const Signatures& signatures, const NamedDistance& distance, Cache& cache);

/// Returns the range of each field over the models that have values of it. Throws ArgumentError if none
/// has.
std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields);

/// Assembles the signatures, in the configuration's order, of all models: row i is of models[i], NaN for a model
/// without the signature. A signature that no model has is without columns. Signatures derived from distances are
/// empty. `data_set_ranges` are the ranges of the fields over the whole data set, if a histogram needs them.
/// Runs in the calling TBB arena. Throws ArgumentError if a descriptor returns features of different lengths.
std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const Field> fields,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges);

/// Returns the range of each model's histogram of a field.
std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field);

}  // namespace shapegauge
