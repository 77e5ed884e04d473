// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// Part of a configuration with parameters: a type of field, perturbation or descriptor, a re-ranking method, or a
/// section of the document.
struct ParameterGroup {
  std::string_view name;                            ///< name of the type, method or section: "offset_sdf", "histogram"
  std::string_view description;                     ///< description in one sentence; empty for a section
  std::span<const Parameter> parameters;            ///< parameters that users can set
  std::span<const Parameter> axis_parameters = {};  ///< parameters of a descriptor per field; empty for other groups
};

/// Return the parameter groups of configurations: types of fields, perturbations and descriptors, re-ranking methods,
/// and sections.
/// @{
std::vector<ParameterGroup> field_groups();
std::vector<ParameterGroup> perturbation_groups();
std::vector<ParameterGroup> descriptor_groups();
std::vector<ParameterGroup> rerank_groups();
std::vector<ParameterGroup> section_groups();
/// @}

/// Returns the definitions of the JSON Schema (draft 7) of configurations, by name: the structure
/// (base_schema.json) with the current entries of the registries of fields, descriptors, perturbations, distances,
/// protocols and layouts. Schemas of the kinds of experiments refer to them as "#/definitions/NAME".
nlohmann::ordered_json schema_definitions();

/// Fills in the lists of settings in docs/reference/configuration.md: replaces the text between a line
/// `<!-- list: NAME -->` and the next line `<!-- end -->` by the settings of the section of that name, or of all
/// `fields`, `perturbations`, `descriptors` or `rerank` methods.
std::string with_reference_lists(std::string_view page);

/// Validates a document against a schema without definitions of its own, which may refer to schema_definitions().
/// Throws InputError for one fault: an unknown key first, with the nearest known one; otherwise the deepest in the
/// document. The message has the source, the path in the notation of `--set`, the fault and the valid values.
void check_by_schema(const nlohmann::json& document, const nlohmann::ordered_json& schema, const std::string& source);

/// Validates a configuration, or a part of one, against the definition of that name in schema_definitions(), such as
/// "descriptor". Throws InputError as check_by_schema() does; `source` prefixes the message.
void check_against_schema(const nlohmann::json& part, const std::string& definition, const std::string& source);

}  // namespace shapegauge
