// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/signature_tables.h"

#include <fmt/format.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/experiments/signatures/cache_keys.h"

namespace shapegauge {

namespace {

/// Returns the union of the ranges of a field over the models that have values of it.
Interval common_range(const std::vector<const ModelDescription*>& models, std::size_t field) {
  std::vector<Interval> ranges;
  for (const ModelDescription* model : models) {
    if (model->fields[field].error.empty()) ranges.push_back(model->fields[field].range);
  }
  return enclosing_interval(ranges);
}

/// Returns the histograms over this range of the field, one row per model.
Signatures histograms_of(const std::vector<const ModelDescription*>& models, std::size_t field, const Interval& range,
                         const HistogramOptions& options) {
  Signatures table(std::ssize(models), options.bins);
  parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    table.row(static_cast<Eigen::Index>(i)) = histogram(to_scalar_field(models[i]->fields[field]), range, options);
  });
  return table;
}

/// Returns the features of a signature that does not depend on other shapes, one row per model.
Signatures features_of(const std::vector<const ModelDescription*>& models, std::size_t signature) {
  const Eigen::Index length = models.front()->features[signature].features.size();
  Signatures table(std::ssize(models), length);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Eigen::VectorXf& features = models[i]->features[signature].features;
    if (features.size() != length) {
      throw ArgumentError(
          fmt::format("a descriptor returned {} features for one model and {} for another", length, features.size()));
    }
    table.row(static_cast<Eigen::Index>(i)) = features.transpose();
  }
  return table;
}

/// Returns a table with the rows of `compact` at these indices and NaN elsewhere; without columns if there are none.
Signatures expand_rows(const Signatures& compact, std::span<const Eigen::Index> indices, std::size_t all) {
  const auto rows = static_cast<Eigen::Index>(all);
  if (compact.rows() == rows) return compact;
  Signatures table =
      Signatures::Constant(rows, indices.empty() ? 0 : compact.cols(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < indices.size(); ++i) table.row(indices[i]) = compact.row(static_cast<Eigen::Index>(i));
  return table;
}

/// Returns, for each signature, the indices of the models that have it.
std::vector<std::vector<Eigen::Index>> models_per_signature(const std::vector<const ModelDescription*>& models,
                                                            const std::vector<SignatureConfiguration>& signatures,
                                                            std::span<const Field> fields) {
  std::vector<std::vector<Eigen::Index>> indices(signatures.size());
  for (std::size_t model = 0; model < models.size(); ++model) {
    const std::vector<std::string> errors = signature_errors(*models[model], signatures, fields);
    for (std::size_t i = 0; i < signatures.size(); ++i) {
      if (errors[i].empty()) indices[i].push_back(static_cast<Eigen::Index>(model));
    }
  }
  return indices;
}

}  // namespace

NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration) {
  if (!signature.descriptor) return distances().at(configuration.distance);
  return {.name = distance_of(signature.descriptor->descriptor), .function = signature.descriptor->descriptor.distance};
}

DistanceMatrix distances_through_cache(const Signatures& signatures, const NamedDistance& distance, Cache& cache) {
  const auto compute = [&] { return distance_matrix(signatures, distance); };
  const bool cached = !cache.folder().empty() && signatures.rows() <= max_models_of_cached_distances;
  return cached ? cache.get(EntryKind::distances, distances_key(signatures, distance.name), compute) : compute();
}

std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields) {
  std::vector<Interval> ranges;
  for (std::size_t field = 0; field < fields; ++field) ranges.push_back(common_range(models, field));
  return ranges;
}

std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const Field> fields,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges) {
  std::vector<Signatures> tables(signatures.size());
  if (models.empty()) return tables;
  const std::vector<std::vector<Eigen::Index>> indices = models_per_signature(models, signatures, fields);
  const auto table_of = [&](std::size_t i) {
    const SignatureConfiguration& signature = signatures[i];
    if (!signature.field && !signature.descriptor) {
      std::vector<Signatures> parts;
      for (const std::size_t part : signature.parts) parts.emplace_back(tables[part](indices[i], Eigen::all));
      return concatenate(parts);
    }
    std::vector<const ModelDescription*> with;
    for (const Eigen::Index model : indices[i]) with.push_back(models[static_cast<std::size_t>(model)]);
    if (!signature.field || signature.histogram.range != HistogramRange::dataset) return features_of(with, i);
    const std::size_t field = index_of(fields, *signature.field);
    return histograms_of(with, field, data_set_ranges[field], signature.histogram.options);
  };
  for (const std::size_t i : computation_order(signatures)) {
    if (signatures[i].derived) continue;
    tables[i] = expand_rows(indices[i].empty() ? Signatures() : table_of(i), indices[i], models.size());
  }
  return tables;
}

std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& settings, std::size_t field) {
  if (settings.range == HistogramRange::fixed) return std::vector(models.size(), settings.fixed);
  if (settings.range == HistogramRange::dataset) return std::vector(models.size(), common_range(models, field));
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return ranges;
}

}  // namespace shapegauge
