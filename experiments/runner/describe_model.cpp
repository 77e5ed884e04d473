#include "shapegauge/experiments/runner/describe_model.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<PlannedField> plan;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const SignatureConfiguration& signature = signatures[i];
    if (!signature.field) continue;
    auto planned = std::ranges::find_if(
        plan, [&](const PlannedField& known) { return known.field.settings == signature.field->settings; });
    if (planned == plan.end())
      planned = plan.insert(plan.end(), PlannedField{.field = *signature.field, .signatures = {}});
    planned->signatures.push_back(i);
    if (signature.histogram.range == HistogramRange::dataset) planned->keep_values = true;
  }
  return plan;
}

bool is_pictured(const PlannedField& planned, const ReportConfiguration& report) {
  return report.wanted && report.pictures &&
         std::ranges::find(planned.signatures, report.pictured_signature) != planned.signatures.end();
}

namespace {

/// The samples of a shape by plan, taken when first asked for.
class SamplesByPlan {
 public:
  explicit SamplesByPlan(const Shape& shape) : shape_(&shape) {}

  const Samples& at(SamplePlan plan) {
    // A cloud has its points, whether faces or vertices are asked for.
    if (is_cloud(*shape_) && plan.site == SampleSite::faces) plan.site = SampleSite::vertices;
    const auto [place, is_new] = samples_.try_emplace(plan);
    if (is_new) place->second = take_samples(*shape_, plan);
    return place->second;
  }

 private:
  const Shape* shape_;
  std::map<SamplePlan, Samples> samples_;
};

/// The values' range, which also says whether there are any.
Interval range_of(const ScalarField& field, const Field& what) {
  if (const std::optional<Interval> range = value_range(field)) return *range;
  throw InputError(fmt::format("no sample has a value of the field {}", what.settings.dump()));
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

ModelDescription describe_shape(PerturbedShape perturbed, const PreparationOptions& preparation,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe) {
  ModelDescription description;
  description.diagnostics = diagnose(perturbed.shape);
  description.chosen = std::move(perturbed.chosen);
  description.histograms.resize(signatures.size());
  const PreparedShape prepared = prepare_shape(std::move(perturbed.shape), preparation);
  description.area = prepared.area;
  description.noise = prepared.noise.relative();
  description.pass_band = prepared.pass_band;
  SamplesByPlan samples(prepared.shape);
  FieldSource source(prepared.shape);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Samples& sites = samples.at(plan[i].field.samples);
    FieldValues computed = plan[i].field.compute(source, sites, parallel);
    const auto end = std::chrono::steady_clock::now();
    if (observe) observe(i, prepared, sites, computed);

    FieldDescription& kept = description.fields.emplace_back();
    kept.outcomes = std::move(computed.outcomes);
    kept.offset = computed.offset;
    kept.seconds = std::chrono::duration<double>(end - start).count();
    const ScalarField field{.values = std::move(computed.values), .weights = sites.weights};
    describe_field(field, plan[i], signatures, kept, description.histograms);
  }
  return description;
}

Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options) {
  return histogram({.values = field.values.cast<double>(), .weights = field.weights.cast<double>()}, range, options);
}

}  // namespace shapegauge
