// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/fields/bilateral.h"
#include "shapegauge/core/fields/field_types.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/core/sdf/offset_sdf.h"

namespace shapegauge {

namespace {

/// Adds smoothing to a field.
FieldComputation smoothed(FieldComputation field, const BilateralOptions& options) {
  field.versions["bilateral"] = bilateral_version;
  field.compute = [compute = std::move(field.compute), options](FieldSource& source, const Samples& samples,
                                                                bool parallel) {
    FieldValues computed = compute(source, samples, parallel);
    const Stopwatch stopwatch;
    ScalarField values{.values = std::move(computed.values), .weights = samples.weights};
    computed.values = bilateral_smoothing(source.shape(), samples, std::move(values), options).values;
    computed.query_seconds += stopwatch.seconds();
    return computed;
  };
  return field;
}

std::vector<FieldType> builtin_fields() {
  return {offset_sdf_type(), cone_sdf_type(),    inscribed_ball_type(),  gap_type(),
          centricity_type(), heat_kernel_type(), scale_invariant_type(), wave_kernel_type()};
}

void check_field_type(const FieldType& type) {
  const auto reserved = [](const Parameter& parameter) {
    return parameter.name == "type" || parameter.name == "at" || parameter.name == "bilateral";
  };
  if (std::ranges::any_of(type.parameters, reserved)) {
    throw ArgumentError(
        fmt::format("a parameter of the field \"{}\" is called type, at or bilateral, which are reserved", type.name));
  }
}

/// Makes a field's function count outcomes and measure run times, unless it does so itself.
FieldFunction with_outcomes(FieldFunction compute) {
  return [compute = std::move(compute)](FieldSource& source, const Samples& samples, bool parallel) {
    const Stopwatch stopwatch;
    FieldValues computed = compute(source, samples, parallel);
    if (computed.build_seconds == 0) computed.query_seconds = stopwatch.seconds();
    if (computed.values.size() != samples.points.rows()) {
      throw std::logic_error(
          fmt::format("a field returned {} values for {} samples", computed.values.size(), samples.points.rows()));
    }
    if (computed.outcomes.empty()) {
      computed.outcomes = {{"total", static_cast<std::size_t>(computed.values.size())},
                           {"missing", static_cast<std::size_t>(computed.values.array().isNaN().count())}};
    }
    return computed;
  };
}

}  // namespace

FieldSource::FieldSource(const Shape& shape, std::optional<ShapeDiagnostics> known)
    : shape_(&shape), known_(known), proxy_(std::make_unique<ProxySource>(shape)) {}

FieldSource::~FieldSource() = default;

const OffsetSdfSolver& FieldSource::offset_sdf_solver() {
  if (!offset_sdf_solver_) offset_sdf_solver_ = std::make_unique<OffsetSdfSolver>(*shape_);
  return *offset_sdf_solver_;
}

const AutomaticOffset& FieldSource::automatic_offset() {
  if (!automatic_offset_) {
    automatic_offset_ = known_ ? shapegauge::automatic_offset(*known_) : shapegauge::automatic_offset(*shape_);
  }
  return *automatic_offset_;
}

const Spectrum& FieldSource::spectrum(int eigenvalues) {
  std::unique_ptr<Spectrum>& spectrum = spectra_[eigenvalues];
  if (!spectrum) spectrum = std::make_unique<Spectrum>(laplacian_spectrum(*shape_, eigenvalues));
  return *spectrum;
}

std::vector<std::string> outcome_warnings(const FieldOutcomes& outcomes) {
  // The offset SDF counts the samples that it answers directly.
  const char* const missing =
      outcomes.contains("direct")
          ? "missing: vertices without triangles, or shapes so far from the origin that their coordinates are rounded"
          : "missing: parts that are open or inside out (offset_sdf measures these), triangles without area, vertices "
            "without triangles, points without normals or, for gaps, nothing opposite";
  const std::array<std::pair<const char*, const char*>, 4> warned{
      {{"undecided", "undecided"},
       {"missing", missing},
       {"two_sided",
        "have the outside on both sides, closer than half the offset: the shape is open there (a hole, a missing base) "
        "or a sheet; their thickness is about 0 and the side of their normals arbitrary; the thickness of an open "
        "shape needs the surface that is missing"},
       {"enlarged", "computed with a larger offset, because the grid of the requested one would not fit into memory"}}};
  std::vector<std::string> warnings;
  for (const auto& [outcome, words] : warned) {
    const auto count = outcomes.find(outcome);
    if (count == outcomes.end() || count->second == 0) continue;
    warnings.push_back(fmt::format("{} of {} samples {}", count->second, outcomes.at("total"), words));
  }
  return warnings;
}

std::optional<std::string> weights_warning(const Samples& samples) {
  const double sum = samples.weights.sum();
  if (samples.weights.size() == 0 || (std::isnormal(sum) && sum > 0)) return std::nullopt;
  return fmt::format(
      "the weights of the samples have the sum {}: the shape has no area, or is too large or too small for "
      "it to be computed; scale the shape",
      sum);
}

double unit_of(FieldDimension dimension, double length) {
  switch (dimension) {
    case FieldDimension::none:
      return 1;
    case FieldDimension::length:
      return length;
    case FieldDimension::area:
      break;
  }
  return length * length;
}

Samples take_samples(const Shape& shape, const SamplePlan& plan) {
  return plan.site == SampleSite::surface ? sample_surface(shape, plan.count) : sample_shape(shape, plan.site);
}

Registry<FieldType>& field_types() {
  static Registry<FieldType> all("field", builtin_fields(), has_functions<&FieldType::make>, check_field_type);
  return all;
}

std::span<const Parameter> bilateral_parameters() {
  static constexpr auto parameters = parameters_of(bilateral_table);
  return parameters;
}

FieldSettings field_settings(std::string_view type) {
  return {.type = std::string(type), .values = ParameterValues(field_types().at(type).parameters)};
}

Field make_field(FieldSettings settings) {
  const FieldType& type = field_types().at(settings.type);
  settings.values.require_complete();
  FieldComputation computation = type.make(settings.values, settings.samples);
  if (settings.smoothing) {
    computation = smoothed(std::move(computation), options_from(bilateral_table, *settings.smoothing));
  }
  return {.settings = std::move(settings),
          .versions = std::move(computation.versions),
          .dimension = computation.dimension,
          .compute = with_outcomes(std::move(computation.compute))};
}

}  // namespace shapegauge
