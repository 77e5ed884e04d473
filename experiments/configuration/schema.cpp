// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/derived_distances.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/metrics/measures.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

std::string_view base_schema();  // base_schema.cpp.in

namespace {

using OrderedJson = nlohmann::ordered_json;

template <typename Types>
std::vector<ParameterGroup> groups_of(const Types& types) {
  std::vector<ParameterGroup> groups;
  for (const auto& type : types) groups.push_back({type.name, type.description, type.parameters});
  return groups;
}

template <typename Entry>
std::vector<ParameterGroup> groups_of(const Registry<Entry>& registry) {
  std::vector<ParameterGroup> groups;
  for (const Entry& type : registry.entries()) groups.push_back({type.name, type.description, type.parameters});
  return groups;
}

template <typename Types>
std::vector<std::string> names_of(const Types& types) {
  std::vector<std::string> names;
  for (const auto& type : types) names.emplace_back(type.name);
  return names;
}

/// Describes a choice of registered entries: "Sentence. name: description; name: description."
template <typename Entry>
std::string described_entries(std::string sentence, const Registry<Entry>& registry) {
  std::vector<std::string> entries;
  for (const Entry& entry : registry.entries()) {
    entries.push_back(entry.description.empty() ? std::string(entry.name)
                                                : fmt::format("{}: {}", entry.name, entry.description));
  }
  return fmt::format("{} {}.", sentence, fmt::join(entries, "; "));
}

/// Adds the parameters to the schema of an object.
void add_parameters(std::span<const Parameter> parameters, OrderedJson& object) {
  for (const Parameter& parameter : parameters) {
    object["properties"][std::string(parameter.name)] = schema_of(parameter);
    if (parameter.required()) object["required"].push_back(parameter.name);
  }
}

/// Returns the schema of the settings of one type of field, perturbation or similar.
OrderedJson schema_of(const ParameterGroup& type, const char* key = "type") {
  OrderedJson schema{{"description", type.description},
                     {"type", "object"},
                     {"additionalProperties", false},
                     {"required", {key}},
                     {"properties", {{key, {{"const", type.name}}}}}};
  add_parameters(type.parameters, schema);
  return schema;
}

/// Adds to the schema of a field, perturbation or similar its "type" (or another key) and the settings of each type.
void add_types(const std::vector<ParameterGroup>& types, const std::vector<OrderedJson>& schemas, OrderedJson& schema,
               const char* key = "type") {
  schema["type"] = "object";
  schema["required"] = {key};
  schema["properties"][key]["enum"] = names_of(types);
  for (std::size_t i = 0; i < types.size(); ++i) {
    const OrderedJson condition{{"required", {key}}, {"properties", {{key, {{"const", types[i].name}}}}}};
    schema["allOf"].push_back({{"if", condition}, {"then", schemas[i]}});
  }
}

void add_fields(OrderedJson& schema) {
  std::vector<OrderedJson> schemas;
  for (const ParameterGroup& type : field_groups()) {
    schemas.push_back(schema_of(type));
    schemas.back()["properties"]["at"] = {{"$ref", "#/definitions/site"}};
    schemas.back()["properties"]["bilateral"] = {{"$ref", "#/definitions/bilateral"}};
  }
  add_types(field_groups(), schemas, schema);
}

void add_descriptors(OrderedJson& schema) {
  std::vector<OrderedJson> schemas;
  for (const Descriptor& type : descriptors().entries()) {
    OrderedJson& settings =
        schemas.emplace_back(schema_of(ParameterGroup{type.name, type.description, type.parameters}));
    if (type.max_fields == 0) continue;
    if (type.min_fields > 0) settings["required"].push_back("fields");
    settings["properties"]["fields"] = {{"type", "array"},
                                        {"minItems", type.min_fields},
                                        {"maxItems", type.max_fields},
                                        {"items", {{"$ref", "#/definitions/field"}}}};
    if (type.axis_parameters.empty()) continue;
    OrderedJson axis{{"description", "Bins and range of the field at the same position in the list."},
                     {"type", "object"},
                     {"additionalProperties", false},
                     {"properties", OrderedJson::object()}};
    add_parameters(type.axis_parameters, axis);
    settings["properties"]["axes"] = {{"type", "array"}, {"maxItems", type.max_fields}, {"items", std::move(axis)}};
  }
  add_types(descriptor_groups(), schemas, schema);
}

/// Adds the layouts, with their default classifications and those that have splits.
void add_layouts(OrderedJson& definitions) {
  std::vector<std::string> defaults;
  std::vector<std::string_view> split;
  for (const DatasetLayout& layout : dataset_layouts().entries()) {
    if (!layout.default_classification.empty()) {
      defaults.push_back(fmt::format("{}: {}", layout.name, layout.default_classification));
    }
    if (layout.has_splits) split.push_back(layout.name);
  }
  definitions["layout"] = {
      {"description", described_entries("Layout of the files, required without `generate`.", dataset_layouts())},
      {"enum", dataset_layouts().names()}};
  definitions["dataset_classification"] = {
      {"description", fmt::format("File with the models' classes (.cla or CSV), relative to root. Defaults: {}.",
                                  fmt::join(defaults, "; "))},
      {"type", "string"},
      {"minLength", 1}};
  definitions["dataset_split"] = {
      {"description", fmt::format("Split to use, for the layouts {}; all: every model.", fmt::join(split, " and "))},
      {"enum", dataset_splits},
      {"default", dataset_splits.front()}};
}

void add_rerank_methods(OrderedJson& schema) {
  std::vector<OrderedJson> schemas;
  for (const ParameterGroup& method : rerank_groups()) {
    OrderedJson& settings = schemas.emplace_back(schema_of(method, "method"));
    settings["required"].push_back("of");
    settings["properties"]["of"] = {{"type", "string"}};
  }
  add_types(rerank_groups(), schemas, schema, "method");
}

void add_perturbations(OrderedJson& schema) {
  std::vector<OrderedJson> schemas;
  for (const PerturbationType& type : perturbation_types()) {
    schemas.push_back(schema_of(ParameterGroup{type.name, type.description, type.parameters}));
    if (!type.has_choices) continue;
    schemas.back()["required"].push_back("choices");
    schemas.back()["properties"]["choices"] = {
        {"type", "array"}, {"minItems", 1}, {"items", {{"$ref", "#/definitions/perturbations"}}}};
  }
  add_types(perturbation_groups(), schemas, schema);
}

}  // namespace

std::vector<ParameterGroup> field_groups() { return groups_of(field_types()); }

std::vector<ParameterGroup> perturbation_groups() { return groups_of(perturbation_types()); }

std::vector<ParameterGroup> descriptor_groups() {
  std::vector<ParameterGroup> groups = groups_of(descriptors());
  for (ParameterGroup& group : groups) group.axis_parameters = descriptors().at(group.name).axis_parameters;
  return groups;
}

std::vector<ParameterGroup> rerank_groups() { return groups_of(rerank_methods()); }

std::vector<ParameterGroup> section_groups() {
  return {{.name = "experiment", .description = {}, .parameters = experiment_parameters()},
          {.name = "generate", .description = {}, .parameters = generator_parameters()},
          {.name = "generated_shape", .description = {}, .parameters = generated_model_parameters()},
          {.name = "preparation", .description = {}, .parameters = preparation_parameters()},
          {.name = "histogram", .description = {}, .parameters = histogram_parameters()},
          {.name = "bilateral", .description = {}, .parameters = bilateral_parameters()},
          {.name = "signature", .description = {}, .parameters = derived_parameters()},
          {.name = "sum_term", .description = {}, .parameters = sum_term_parameters()},
          {.name = "evaluation", .description = {}, .parameters = evaluation_parameters()},
          {.name = "segmentation_experiment", .description = {}, .parameters = segmentation_experiment_parameters()},
          {.name = "segmentation_method", .description = {}, .parameters = segmentation_method_parameters()}};
}

OrderedJson schema_definitions() {
  OrderedJson definitions = OrderedJson::parse(base_schema()).at("definitions");
  for (const ParameterGroup& section : section_groups()) {
    if (section.name != "experiment") add_parameters(section.parameters, definitions[std::string(section.name)]);
  }
  for (const char* experiment : {"retrieval_experiment", "comparison_experiment"}) {
    add_parameters(experiment_parameters(), definitions[experiment]);
  }
  add_fields(definitions["field"]);
  add_perturbations(definitions["perturbation"]);
  add_descriptors(definitions["descriptor"]);
  add_rerank_methods(definitions["rerank"]);
  add_layouts(definitions);
  OrderedJson& segmented_layouts = definitions["segmented_dataset"]["properties"]["layout"]["enum"];
  segmented_layouts = dataset_layouts().names();
  segmented_layouts.insert(segmented_layouts.begin(), segmentation_layout);
  definitions["report"]["then"]["properties"]["up"] = schema_of(up_parameter());
  definitions["protocol"]["enum"] = list_of_words<Protocol>();
  definitions["distance"]["description"] = described_entries("Distance between field histograms a and b.", distances());
  definitions["distance"]["enum"] = distances().names();
  definitions["evaluation"]["properties"]["measures"]["description"] = fmt::format(
      "Measures, such as P@10 (default: those of the protocols). Available (k: cut-off rank; N: list length): {}.",
      fmt::join(measure_definitions().names(), ", "));
  return definitions;
}

}  // namespace shapegauge
