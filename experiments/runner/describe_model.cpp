#include "shapegauge/experiments/runner/describe_model.h"

#include <array>
#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/sdf/scalar_field.h"
#include "shapegauge/core/shape/normalise.h"
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
  const Shape shape = scaled_to_unit_area(std::move(perturbed.shape));
  SamplesBySite samples(shape);
  for (const PlannedField& planned : plan) {
    const auto start = std::chrono::steady_clock::now();
    const Samples& sites = samples.at(planned.field.site);
    FieldValues computed = planned.field.compute(shape, sites, parallel);
    const ScalarField field{.values = std::move(computed.values), .weights = sites.weights};

    FieldDescription& kept = description.fields.emplace_back();
    kept.outcomes = std::move(computed.outcomes);
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
