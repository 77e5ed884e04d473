// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/experiment_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"

namespace shapegauge {

namespace {

std::string describe(const HistogramConfiguration& histogram) {
  std::string text = fmt::format("{} bins", histogram.options.bins);
  if (histogram.options.smoothing_bins > 0)
    text += fmt::format(", smoothed by {} bins", histogram.options.smoothing_bins);
  switch (histogram.range) {
    case HistogramRange::per_shape:
      return text + ", range of each shape";
    case HistogramRange::dataset:
      return text + ", range of the data set";
    case HistogramRange::fixed:
      break;
  }
  return text + fmt::format(", range {} to {}", histogram.fixed.low, histogram.fixed.high);
}

/// Formats a setting without braces and quotation marks: objects as "a 1, b 2", lists as "4, 5, 7", and lists of
/// objects with semicolons.
std::string setting_text(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_structured()) return value.dump();
  std::vector<std::string> parts;
  for (const auto& [key, part] : value.items()) {
    parts.push_back(value.is_object() ? fmt::format("{} {}", key, setting_text(part)) : setting_text(part));
  }
  const bool of_objects = value.is_array() && !value.empty() && value.front().is_structured();
  return fmt::format("{}", fmt::join(parts, of_objects ? "; " : ", "));
}

ReportSettings settings_table(const nlohmann::json& settings) {
  ReportSettings table;
  for (const auto& [key, value] : settings.items()) table.emplace_back(key, setting_text(value));
  return table;
}

ReportSettings settings_of(const SignatureConfiguration& signature, const std::vector<SignatureConfiguration>& all) {
  if (signature.field) {
    ReportSettings settings = settings_table(to_json(signature.field->settings));
    settings.emplace_back("histogram", describe(signature.histogram));
    return settings;
  }
  if (signature.descriptor) return settings_table(to_json(*signature.descriptor));
  if (signature.derived) return settings_table(to_json(*signature.derived));
  std::vector<std::string> parts;
  for (const std::size_t part : signature.parts) parts.push_back(all[part].name);
  return {{"concatenate", fmt::format("{}", fmt::join(parts, " + "))}};
}

/// Returns the registered name of the distance, or that of its descriptor.
std::string distance_name(const SignatureConfiguration& signature, const Configuration& configuration) {
  if (signature.derived) return std::string(key_of(*signature.derived));
  if (!signature.descriptor) return configuration.distance;
  const Descriptor& descriptor = signature.descriptor->descriptor;
  for (const NamedDistance& known : distances().entries()) {
    if (known.function == descriptor.distance) return known.name;
  }
  return std::string(descriptor.name);
}

std::vector<std::pair<std::string, ReportSettings>> perturbations_of(const Configuration& configuration) {
  std::vector<std::pair<std::string, ReportSettings>> steps;
  for (nlohmann::json step : to_json(configuration.perturbations)) {
    const auto type = step.at("type").get<std::string>();
    step.erase("type");
    steps.emplace_back(type, settings_table(step));
  }
  return steps;
}

std::vector<ReportLeak> leaks_of(const ExperimentResults& results) {
  std::vector<ReportLeak> found;
  for (std::size_t i = 0; i < results.shapes.size(); ++i) {
    const ModelDescription& shape = results.shapes[i];
    for (std::size_t field = 0; field < results.fields.size(); ++field) {
      const FieldSettings& settings = results.fields[field].settings;
      const std::optional<double> offset =
          shape.fields[field].offset ? shape.fields[field].offset : fixed_offset(settings);
      if (!offset_leaks(shape.diagnostics, offset)) continue;
      found.push_back({.id = results.models[i].id,
                       .field = setting_text(to_json(settings)),
                       .offset = *offset,
                       .gap = shape.diagnostics.gap_size / shape.diagnostics.diagonal});
    }
  }
  return found;
}

std::vector<std::pair<std::string, std::string>> facts_of(const Configuration& configuration) {
  std::vector<std::pair<std::string, std::string>> facts;
  if (configuration.generator) {
    const GeneratorOptions& made = *configuration.generator;
    facts.emplace_back("Data set", fmt::format("generated, {} classes of {} models, {} faces, seed {}", made.classes,
                                               made.models_per_class, made.faces, made.seed));
  } else {
    facts.emplace_back("Data set", configuration.location.value().layout + " layout");
  }
  if (!configuration.perturbations.empty()) facts.emplace_back("Seed", fmt::format("{}", configuration.seed));
  return facts;
}

ReportMethod method_of(const MethodResults& method, const SignatureConfiguration& signature,
                       const ExperimentResults& results, std::span<const NamedEvaluation> evaluations) {
  const Configuration& configuration = results.configuration;
  ReportMethod shown{.name = method.name,
                     .distance = distance_name(signature, configuration),
                     .settings = settings_of(signature, configuration.signatures),
                     .distances = &method.overview,
                     .evaluations = method.evaluations,
                     .intervals = {},
                     .histograms = {.table = signature.field ? &method.signatures : nullptr,
                                    .ranges = method.histogram_ranges,
                                    .parts = signature.derived ? std::vector<std::size_t>() : signature.parts}};
  for (const ModelFailure& failure : method.failures) {
    shown.failures.emplace_back(results.models[failure.model].id, failure.message);
  }
  for (const NamedEvaluation& named : evaluations) shown.intervals.push_back(named.intervals);
  return shown;
}

}  // namespace

Report experiment_report(const ExperimentResults& results, std::span<const NamedEvaluation> evaluations) {
  const Configuration& configuration = results.configuration;
  Report report;
  report.title = configuration.name;
  report.description = configuration.description;
  report.facts = facts_of(configuration);
  report.classes = results.classes;
  for (const Model& model : results.models) {
    report.ids.push_back(model.id);
    report.labels.push_back(model.label);
  }
  for (std::size_t i = 0; i < results.methods.size(); ++i) {
    const std::size_t count = results.methods[i].evaluations.size();
    report.methods.push_back(
        method_of(results.methods[i], configuration.signatures[i], results, evaluations.subspan(i * count, count)));
  }
  if (configuration.report.pictures) {
    report.pictures = {.png = results.pictures,
                       .range = configuration.report.picture_options.range,
                       .field = configuration.signatures[configuration.report.pictured_signature].name};
  }
  report.views = {.fields = results.viewed, .shapes = results.views};
  report.perturbations = perturbations_of(configuration);
  report.warnings = run_warnings(results);
  report.leaks = leaks_of(results);
  for (const LeftOutShape& failure : results.failures) report.failures.emplace_back(failure.id, failure.message);
  return report;
}

}  // namespace shapegauge
