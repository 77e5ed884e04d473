#include "shapegauge/experiments/signatures/describe_model.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/configuration/field_settings.h"

namespace shapegauge {

namespace {

/// Returns the index of the field in the plan; the plan's size if missing.
std::size_t place_in(std::span<const PlannedField> plan, const Field& field) {
  const auto same = [&](const PlannedField& known) { return known.field.settings == field.settings; };
  return static_cast<std::size_t>(std::ranges::find_if(plan, same) - plan.begin());
}

/// Returns the plan's entry for the field, adding it if it is new.
PlannedField& planned(std::vector<PlannedField>& plan, const Field& field) {
  const std::size_t place = place_in(plan, field);
  if (place == plan.size()) plan.push_back({.field = field, .signatures = {}});
  return plan[place];
}

}  // namespace

std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<PlannedField> plan;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const SignatureConfiguration& signature = signatures[i];
    if (signature.field) {
      PlannedField& field = planned(plan, *signature.field);
      field.signatures.push_back(i);
      if (signature.histogram.range == HistogramRange::dataset) field.keep_values = true;
    } else if (signature.descriptor) {
      const DescriptorChoice& choice = *signature.descriptor;
      for (const Field& of_descriptor : choice.fields) {
        PlannedField& field = planned(plan, of_descriptor);
        if (needs_learning(choice.descriptor, choice.values)) field.keep_values = true;
      }
    }
  }
  return plan;
}

std::vector<PlannedDescriptor> plan_descriptors(const std::vector<SignatureConfiguration>& signatures,
                                                std::span<const PlannedField> plan) {
  std::vector<PlannedDescriptor> descriptors;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (!signatures[i].descriptor) continue;
    const DescriptorChoice& choice = *signatures[i].descriptor;
    PlannedDescriptor& added = descriptors.emplace_back();
    added.signature = i;
    added.learns = needs_learning(choice.descriptor, choice.values);
    for (const Field& field : choice.fields) added.fields.push_back(place_in(plan, field));
  }
  return descriptors;
}

std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const PlannedField> plan) {
  std::vector<std::string> errors(signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) errors[i] = model.fields[field].error;
  }
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(signatures, plan);
  for (std::size_t d = 0; d < model.features.size(); ++d) {
    std::string& error = errors[descriptors[d].signature];
    for (const std::size_t field : descriptors[d].fields) {
      if (error.empty()) error = model.fields[field].error;
    }
    if (error.empty()) error = model.features[d].error;
  }
  for (const std::size_t i : computation_order(signatures)) {
    for (const std::size_t part : signatures[i].parts) {
      if (errors[i].empty()) errors[i] = errors[part];
    }
  }
  return errors;
}

bool is_pictured(const PlannedField& planned, const Configuration& configuration) {
  const ReportConfiguration& report = configuration.report;
  if (!report.wanted || !report.pictures) return false;
  return planned.field.settings == pictured_field(configuration.signatures[report.pictured_signature])->settings;
}

std::vector<std::size_t> viewed_fields(std::span<const PlannedField> plan, const Configuration& configuration) {
  std::vector<std::size_t> fields;
  const ReportConfiguration& report = configuration.report;
  if (!report.wanted || !report.pictures || !report.views) return fields;
  for (const bool pictured : {true, false}) {
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (is_pictured(plan[i], configuration) != pictured || (!pictured && plan[i].signatures.empty())) continue;
      if (fields.size() < most_viewed_fields) fields.push_back(i);
    }
  }
  return fields;
}

namespace {

/// Samples of a shape by plan, computed on first use.
class SamplesByPlan {
 public:
  explicit SamplesByPlan(const Shape& shape) : shape_(&shape) {}

  const Samples& at(SamplePlan plan) {
    // A cloud is sampled at its points for either site.
    if (is_cloud(*shape_) && plan.site == SampleSite::faces) plan.site = SampleSite::vertices;
    const auto [place, is_new] = samples_.try_emplace(plan);
    if (is_new) place->second = take_samples(*shape_, plan);
    return place->second;
  }

 private:
  const Shape* shape_;
  std::map<SamplePlan, Samples> samples_;
};

/// Returns the range of values; throws if there are none.
Interval range_of(const ScalarField& field, const Field& what) {
  if (const std::optional<Interval> range = value_range(field)) return *range;
  throw InputError(fmt::format("the field {} has no value at any sample", to_json(what.settings).dump()));
}

}  // namespace

void describe_field(const ScalarField& field, const PlannedField& planned,
                    const std::vector<SignatureConfiguration>& signatures, FieldDescription& kept,
                    std::vector<Eigen::VectorXf>& histograms) {
  kept.range = range_of(field, planned.field);
  for (const std::size_t i : planned.signatures) {
    const HistogramConfiguration& wanted = signatures[i].histogram;
    if (wanted.range == HistogramRange::dataset) continue;
    const Interval& range = wanted.range == HistogramRange::fixed ? wanted.fixed : kept.range;
    histograms[i] = histogram(field, range, wanted.options);
  }
  if (planned.keep_values) {
    kept.values = field.values.cast<float>();
    kept.weights = field.weights.cast<float>();
  }
}

PreparedModel prepare_model(PerturbedShape perturbed, const PreparationOptions& preparation,
                            const ShapeDiagnostics* known) {
  ModelDescription description;
  description.diagnostics = known != nullptr ? *known : diagnose(perturbed.shape);
  description.chosen = std::move(perturbed.chosen);
  description.remarks = std::move(perturbed.remarks);
  PreparedShape prepared = prepare_shape(std::move(perturbed.shape), preparation);
  description.area = prepared.area;
  description.noise = prepared.noise.relative();
  description.pass_band = prepared.pass_band;
  return {.prepared = std::move(prepared), .description = std::move(description)};
}

namespace {

/// Computes the planned field of index i and its histograms.
FieldDescription computed_field(std::size_t i, PreparedModel& model, FieldSource& source, SamplesByPlan& samples,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe) {
  const Stopwatch stopwatch;
  const Samples& sites = samples.at(plan[i].field.settings.samples);
  FieldValues computed = plan[i].field.compute(source, sites, parallel);
  FieldDescription kept;
  kept.seconds = stopwatch.seconds();
  if (observe) observe(i, model.prepared, sites, computed);
  kept.outcomes = std::move(computed.outcomes);
  kept.offset = computed.offset;
  const ScalarField field{.values = std::move(computed.values), .weights = sites.weights};
  describe_field(field, plan[i], signatures, kept, model.description.histograms);
  return kept;
}

}  // namespace

void describe_fields(PreparedModel& model, FieldSource& source, const std::vector<SignatureConfiguration>& signatures,
                     std::span<const PlannedField> plan, bool parallel, OnError on_error,
                     const FieldObserver& observe) {
  model.description.histograms.resize(signatures.size());
  SamplesByPlan samples(model.prepared.shape);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    FieldDescription& kept = model.description.fields.emplace_back();
    try {
      kept = computed_field(i, model, source, samples, signatures, plan, parallel, observe);
    } catch (const InputError& error) {
      if (on_error == OnError::stop) throw;
      kept.error = error.what();
    }
  }
}

ModelDescription describe_shape(PerturbedShape perturbed, const PreparationOptions& preparation,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe) {
  PreparedModel model = prepare_model(std::move(perturbed), preparation);
  FieldSource source(model.prepared.shape, model.known_diagnostics());
  describe_fields(model, source, signatures, plan, parallel, OnError::stop, observe);
  return std::move(model.description);
}

FeatureDescription describe_features(const DescriptorChoice& choice, const DescriptorInput& input,
                                     const LearntFeatures& learnt) {
  const Stopwatch stopwatch;
  Eigen::VectorXf features = compute_features(choice.descriptor, input, learnt, choice.values);
  return {.features = std::move(features), .seconds = stopwatch.seconds()};
}

ScalarField kept_field(const FieldDescription& field) {
  return {.values = field.values.cast<double>(), .weights = field.weights.cast<double>()};
}

Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options) {
  return histogram(kept_field(field), range, options);
}

}  // namespace shapegauge
