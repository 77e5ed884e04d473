// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/descriptor_choice.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

const Json& list_in(const Json& settings, const char* key) {
  static const Json none = Json::array();
  const auto found = settings.find(key);
  return found == settings.end() ? none : *found;
}

/// Describes the number of fields that the descriptor needs.
std::string field_count_text(const Descriptor& descriptor) {
  if (descriptor.max_fields == 0) return "none";
  return fmt::format("{} to {}", descriptor.min_fields, descriptor.max_fields);
}

std::vector<Field> fields_of(const Json& list, const Descriptor& descriptor) {
  if (list.size() < descriptor.min_fields || list.size() > descriptor.max_fields) {
    throw ConfigurationError{"fields", fmt::format("the descriptor {} needs {}, not {}", descriptor.name,
                                                   field_count_text(descriptor), list.size())};
  }
  std::vector<Field> fields;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string path = fmt::format("fields.{}", i);
    fields.push_back(at_key(path, [&] { return read_field(list[i]); }));
    if (fields.back().settings.samples != fields.front().settings.samples) {
      throw ConfigurationError{path + ".at", R"(the fields of a descriptor must have the same "at")"};
    }
  }
  return fields;
}

std::vector<ParameterValues> axes_of(const Json& list, const Descriptor& descriptor, std::size_t fields) {
  if (list.size() > fields || (!list.empty() && descriptor.axis_parameters.empty())) {
    throw ConfigurationError{"axes", fmt::format("the descriptor {} has at most {} axes, not {}", descriptor.name,
                                                 descriptor.axis_parameters.empty() ? 0 : fields, list.size())};
  }
  std::vector<ParameterValues> axes(fields, ParameterValues(descriptor.axis_parameters));
  for (std::size_t i = 0; i < list.size(); ++i) {
    axes[i] = at_key(fmt::format("axes.{}", i), [&] { return read_parameters(descriptor.axis_parameters, list[i]); });
  }
  return axes;
}

}  // namespace

DescriptorChoice make_descriptor(const Json& settings) {
  const Descriptor& chosen = descriptors().at(settings.at("type").get<std::string>());
  std::vector<Field> fields = fields_of(list_in(settings, "fields"), chosen);
  const std::size_t count = fields.size();
  DescriptorChoice choice{.descriptor = chosen,
                          .values = {.values = read_parameters(chosen.parameters, settings),
                                     .axes = axes_of(list_in(settings, "axes"), chosen, count)},
                          .fields = std::move(fields)};
  if (chosen.check != nullptr) chosen.check(choice.values);
  return choice;
}

Json to_json(const DescriptorChoice& choice) {
  Json settings = to_json(choice.values.values);
  settings["type"] = choice.descriptor.name;
  for (const Field& field : choice.fields) settings["fields"].push_back(to_json(field.settings));
  if (choice.descriptor.axis_parameters.empty()) return settings;
  for (const ParameterValues& axis : choice.values.axes) settings["axes"].push_back(to_json(axis));
  return settings;
}

bool needs_learning(const DescriptorChoice& choice) { return needs_learning(choice.descriptor, choice.values); }

DescriptorFields compute_fields(const DescriptorChoice& choice, FieldSource& source) {
  DescriptorFields result;
  if (choice.fields.empty()) return result;
  const auto add = [&](const std::optional<std::string>& warning) {
    if (warning && std::ranges::find(result.warnings, *warning) == result.warnings.end()) {
      result.warnings.push_back(*warning);
    }
  };
  const Samples samples = take_samples(source.shape(), choice.fields.front().settings.samples);
  for (const Field& field : choice.fields) {
    FieldValues computed = field.compute(source, samples, true);
    result.fields.push_back({.values = std::move(computed.values), .weights = samples.weights});
    for (const std::string& warning : outcome_warnings(computed.outcomes)) add(warning);
    const std::optional<ChosenOffset> offset = offset_of(field.settings, source);
    if (!offset) continue;
    add(leak_warning(*offset));
    add(hollow_remark(source.shape(), true));
  }
  return result;
}

}  // namespace shapegauge
