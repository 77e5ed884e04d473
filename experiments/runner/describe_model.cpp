#include "shapegauge/experiments/runner/describe_model.h"

#include <array>
#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/sdf/scalar_field.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

namespace {

/// The samples of a shape at each site, made when first asked for.
class SamplesBySite {
 public:
  explicit SamplesBySite(const Shape& shape) : shape_(&shape) {}

  const Samples& at(SampleSite site) {
    const bool at_faces = site == SampleSite::faces && !is_cloud(*shape_);  // a cloud has one kind of samples
    std::optional<Samples>& samples = samples_[at_faces ? 0 : 1];
    if (!samples) samples = sample_shape(*shape_, site);
    return *samples;
  }

 private:
  const Shape* shape_;
  std::array<std::optional<Samples>, 2> samples_;
};

/// The values' range, which also says whether there are any.
Interval range_of(const ScalarField& field, const Field& what) {
  if (const std::optional<Interval> range = value_range(field)) return *range;
  throw InputError(fmt::format("no sample has a value of the field {}", what.settings.dump()));
}

/// The histograms of a field that need no other shape, and what is kept of its values.
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

}  // namespace

ModelDescription describe_shape(PerturbedShape perturbed, const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe) {
  ModelDescription description;
  description.diagnostics = diagnose(perturbed.shape);
  description.chosen = std::move(perturbed.chosen);
  description.histograms.resize(signatures.size());
  const PreparedShape prepared = prepare_shape(std::move(perturbed.shape));
  SamplesBySite samples(prepared.shape);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Samples& sites = samples.at(plan[i].field.site);
    FieldValues computed = plan[i].field.compute(prepared.shape, sites, parallel);
    const auto end = std::chrono::steady_clock::now();
    if (observe) observe(i, prepared, sites, computed);

    FieldDescription& kept = description.fields.emplace_back();
    kept.outcomes = std::move(computed.outcomes);
    kept.seconds = std::chrono::duration<double>(end - start).count();
    const ScalarField field{.values = std::move(computed.values), .weights = sites.weights};
    describe_field(field, plan[i], signatures, kept, description.histograms);
  }
  return description;
}

ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const PlannedField> plan, bool parallel) {
  const Model& source = dataset.models[model];
  return describe_shape(
      perturb_model(read_shape(source.file), configuration.perturbations, configuration.seed, source.id, model),
      configuration.signatures, plan, parallel);
}

Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options) {
  return histogram({.values = field.values.cast<double>(), .weights = field.weights.cast<double>()}, range, options);
}

}  // namespace shapegauge
