#include "shapegauge/experiments/retrieval/experiment_report.h"

#include <fmt/format.h>

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

/// The settings as "key value", each followed by ", ".
std::string describe(const nlohmann::json& settings) {
  std::string text;
  for (const auto& [key, value] : settings.items()) {
    text += fmt::format("{} {}, ", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

std::string describe(const SignatureConfiguration& signature, const std::vector<SignatureConfiguration>& all) {
  if (signature.field) return describe(to_json(signature.field->settings)) + describe(signature.histogram);
  if (signature.descriptor || signature.derived) {
    std::string text = describe(signature.descriptor ? signature.descriptor->settings : signature.derived->settings);
    text.resize(text.size() - 2);
    return text;
  }
  std::string text = "concatenation of";
  for (const std::size_t part : signature.parts)
    text += fmt::format("{} {}", text.ends_with("of") ? "" : " +", all[part].name);
  return text;
}

std::vector<std::pair<std::string, std::string>> facts_of(const Configuration& configuration) {
  std::vector<std::pair<std::string, std::string>> facts{{"Distance", configuration.distance}};
  if (configuration.generator) {
    const GeneratorOptions& made = *configuration.generator;
    facts.emplace_back("Data set", fmt::format("generated, {} classes of {} models, {} faces, seed {}", made.classes,
                                               made.models_per_class, made.faces, made.seed));
  } else {
    facts.emplace_back("Data set", configuration.location.value().layout + " layout");
  }
  if (!configuration.perturbations.empty()) {
    facts.emplace_back("Perturbations", to_json(configuration.perturbations).dump());
    facts.emplace_back("Seed", fmt::format("{}", configuration.seed));
  }
  return facts;
}

ReportMethod method_of(const MethodResults& method, const SignatureConfiguration& signature,
                       const std::vector<SignatureConfiguration>& all) {
  return {.name = method.name,
          .description = describe(signature, all),
          .distances = &method.overview,
          .evaluations = method.evaluations,
          .histograms = {.table = signature.field ? &method.signatures : nullptr,
                         .ranges = method.histogram_ranges,
                         .parts = signature.derived ? std::vector<std::size_t>() : signature.parts}};
}

}  // namespace

Report report_of(const ExperimentResults& results) {
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
    report.methods.push_back(method_of(results.methods[i], configuration.signatures[i], configuration.signatures));
  }
  if (configuration.report.pictures) {
    report.pictures = {.png = results.pictures,
                       .range = configuration.report.picture_options.range,
                       .field = configuration.signatures[configuration.report.pictured_signature].name};
  }
  report.views = {.fields = results.viewed, .shapes = results.views};
  report.warnings = run_warnings(results);
  for (const FailedModel& failure : results.failures) report.failures.emplace_back(failure.model.id, failure.message);
  return report;
}

}  // namespace shapegauge
