#include "shapegauge/experiments/signatures/signature_tables.h"

#include <fmt/format.h>
#include <limits>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

/// Returns the union of the ranges of a field over all models.
Interval common_range(const std::vector<const ModelDescription*>& models, std::size_t field) {
  return enclosing_interval(model_ranges(models, field));
}

/// Returns one histogram signature of models that have it.
Signatures histograms_of(const std::vector<const ModelDescription*>& models, const HistogramConfiguration& wanted,
                         std::size_t signature, std::size_t field, std::span<const Interval> data_set_ranges) {
  Signatures table(static_cast<Eigen::Index>(models.size()), wanted.options.bins);
  const bool of_dataset = wanted.range == HistogramRange::dataset;
  parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    table.row(static_cast<Eigen::Index>(i)) =
        of_dataset ? kept_histogram(models[i]->fields[field], data_set_ranges[field], wanted.options)
                   : models[i]->histograms[signature];
  });
  return table;
}

/// Returns the features of one descriptor of models that have them.
Signatures features_of(const std::vector<const ModelDescription*>& models, std::size_t descriptor) {
  const Eigen::Index length = models.front()->features[descriptor].features.size();
  Signatures table(std::ssize(models), length);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Eigen::VectorXf& features = models[i]->features[descriptor].features;
    if (features.size() != length) {
      throw different_feature_counts(length, features.size());
    }
    table.row(static_cast<Eigen::Index>(i)) = features.transpose();
  }
  return table;
}

/// Returns a table with the rows of `some` at these places and NaN elsewhere; without columns if there are none.
Signatures rows_at_places(const Signatures& some, std::span<const Eigen::Index> places, std::size_t all) {
  const auto rows = static_cast<Eigen::Index>(all);
  if (some.rows() == rows) return some;
  Signatures table =
      Signatures::Constant(rows, places.empty() ? 0 : some.cols(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < places.size(); ++i) table.row(places[i]) = some.row(static_cast<Eigen::Index>(i));
  return table;
}

/// Positions of the models with each signature.
std::vector<std::vector<Eigen::Index>> places_with(const std::vector<const ModelDescription*>& models,
                                                   const std::vector<SignatureConfiguration>& signatures,
                                                   std::span<const PlannedField> plan) {
  std::vector<std::vector<Eigen::Index>> places(signatures.size());
  for (std::size_t model = 0; model < models.size(); ++model) {
    const std::vector<std::string> errors = signature_errors(*models[model], signatures, plan);
    for (std::size_t i = 0; i < signatures.size(); ++i) {
      if (errors[i].empty()) places[i].push_back(static_cast<Eigen::Index>(model));
    }
  }
  return places;
}

}  // namespace

ArgumentError different_feature_counts(Eigen::Index one, Eigen::Index other) {
  return ArgumentError(fmt::format("a descriptor returned {} features for one model and {} for another", one, other));
}

std::vector<Interval> model_ranges(const std::vector<const ModelDescription*>& models, std::size_t field) {
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) {
    if (model->fields[field].error.empty()) ranges.push_back(model->fields[field].range);
  }
  return ranges;
}

NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration) {
  if (!signature.descriptor) return distances().at(configuration.distance);
  return {.name = distance_of(signature.descriptor->descriptor), .function = signature.descriptor->descriptor.distance};
}

std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields) {
  std::vector<Interval> ranges;
  for (std::size_t field = 0; field < fields; ++field) ranges.push_back(common_range(models, field));
  return ranges;
}

std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges) {
  std::vector<Signatures> tables(signatures.size());
  if (models.empty()) return tables;
  const std::vector<std::vector<Eigen::Index>> places = places_with(models, signatures, plan);
  const auto set_table = [&](std::size_t i, const auto& table_of) {
    std::vector<const ModelDescription*> with;
    for (const Eigen::Index place : places[i]) with.push_back(models[static_cast<std::size_t>(place)]);
    tables[i] = rows_at_places(with.empty() ? Signatures() : table_of(with), places[i], models.size());
  };
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      set_table(
          i, [&](const auto& with) { return histograms_of(with, signatures[i].histogram, i, field, data_set_ranges); });
    }
  }
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(signatures, plan);
  for (std::size_t d = 0; d < descriptors.size(); ++d) {
    set_table(descriptors[d].signature, [&](const auto& with) { return features_of(with, d); });
  }
  for (const std::size_t i : computation_order(signatures)) {
    if (signatures[i].field || signatures[i].descriptor || signatures[i].derived) continue;
    set_table(i, [&](const auto&) {
      std::vector<Signatures> parts;
      for (const std::size_t part : signatures[i].parts) parts.push_back(tables[part](places[i], Eigen::all));
      return concatenate(parts);
    });
  }
  return tables;
}

std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field) {
  if (wanted.range == HistogramRange::fixed) return std::vector(models.size(), wanted.fixed);
  if (wanted.range == HistogramRange::dataset) return std::vector(models.size(), common_range(models, field));
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return ranges;
}

}  // namespace shapegauge
