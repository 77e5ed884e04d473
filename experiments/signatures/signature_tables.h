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

/// Tables of signatures, one row per model, assembled from the descriptions of models.

namespace shapegauge {

/// Returns the distance between two feature vectors of a signature: the descriptor's own distance, if it has one,
/// otherwise the distance of the configuration. The signature must not have derived distances.
NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration);

/// Maximum number of models of a cached distance matrix, whose size is then 64 MB. A larger matrix is computed as fast
/// as it is read.
inline constexpr Eigen::Index max_models_of_cached_distances = 2900;

/// Returns the distance matrix of signatures (distance_matrix()), computed or read from the cache. Stores it there for
/// up to max_models_of_cached_distances signatures. Throws as distance_matrix() does.
DistanceMatrix distances_through_cache(const Signatures& signatures, const NamedDistance& distance, Cache& cache);

/// Returns, per field, the interval of its values over the models that have the field. `fields` is the number of
/// fields. Throws ArgumentError for a field that no model has.
std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields);

/// Assembles one table per signature, in the order of the configuration: row i is the signature of models[i], or NaN if
/// the model does not have it. The table of a signature that no model has is without columns; that of derived distances
/// is empty. `data_set_ranges` are the ranges of the fields over the whole data set, if a histogram needs them. Runs in
/// the calling TBB arena. Throws ArgumentError if a descriptor returns features of different lengths.
std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const Field> fields,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges);

/// Returns, per model, the range of its histogram. `settings` are the settings of the histogram; `field` is the index
/// of its field.
std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& settings, std::size_t field);

}  // namespace shapegauge
