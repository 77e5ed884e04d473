#include "shapegauge/experiments/runner/describe_model.h"

#include <chrono>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/sdf/scalar_field.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

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

ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const PlannedField> plan, bool parallel) {
  const std::vector<SignatureConfiguration>& signatures = configuration.signatures;
  const Model& source = dataset.models[model];
  PerturbedShape perturbed =
      perturb_model(read_shape(source.file), configuration.perturbations, configuration.seed, source.id, model);
  ModelDescription description;
  description.diagnostics = diagnose(perturbed.shape);
  description.chosen = std::move(perturbed.chosen);
  description.histograms.resize(signatures.size());
  const PreparedShape prepared = prepare_shape(std::move(perturbed.shape), configuration.preparation);
  description.noise = prepared.noise.relative();
  description.pass_band = prepared.pass_band;
  const Shape& shape = prepared.shape;
  SamplesByPlan samples(shape);
  for (const PlannedField& planned : plan) {
    const auto start = std::chrono::steady_clock::now();
    const Samples& sites = samples.at(planned.field.samples);
    FieldValues computed = planned.field.compute(shape, sites, parallel);
    const ScalarField field{.values = std::move(computed.values), .weights = sites.weights};

    FieldDescription& kept = description.fields.emplace_back();
    kept.outcomes = std::move(computed.outcomes);
    kept.offset = computed.offset;
    kept.range = range_of(field, planned.field);
    for (const std::size_t i : planned.signatures) {
      const HistogramConfiguration& wanted = signatures[i].histogram;
      if (wanted.range == HistogramRange::dataset) continue;
      const Interval& range = wanted.range == HistogramRange::fixed ? wanted.fixed : kept.range;
      description.histograms[i] = histogram(field, range, wanted.options);
    }
    if (planned.keep_values) {
      kept.values = field.values.cast<float>();
      kept.weights = field.weights.cast<float>();
    }
    kept.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  return description;
}

Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options) {
  return histogram({.values = field.values.cast<double>(), .weights = field.weights.cast<double>()}, range, options);
}

}  // namespace shapegauge
