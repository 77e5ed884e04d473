#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// Something in a configuration that has parameters: a type of field, of perturbation or of descriptor, a way to
/// re-rank, or a section of the document.
struct ParameterGroup {
  std::string_view name;         ///< "offset_sdf", "histogram"
  std::string_view description;  ///< empty for a section
  std::span<const Parameter> parameters;
  std::span<const Parameter> axis_parameters = {};  ///< of a descriptor: of each of its fields
};

/// The types of fields, perturbations and descriptors, the ways to re-rank, and the sections.
/// @{
std::vector<ParameterGroup> field_groups();
std::vector<ParameterGroup> perturbation_groups();
std::vector<ParameterGroup> descriptor_groups();
std::vector<ParameterGroup> rerank_groups();
std::vector<ParameterGroup> section_groups();
/// @}

/// The JSON Schema (draft 7) of an experiment's configuration: the structure (base_schema.json), filled in with the
/// fields, descriptors, perturbations, distances, protocols and layouts that the registries have at the moment.
/// configs/experiment.schema.json is this text, for editors.
std::string experiment_schema();

/// The text of docs/reference/configuration.md with its tables filled in: what stands between a line `<!-- NAME -->`
/// and the next line `<!-- end -->` is replaced by the tables of the group of that name, or of all `fields`,
/// `perturbations`, `descriptors` or ways to `rerank`.
std::string with_reference_tables(std::string_view page);

/// Holds a configuration to the experiment schema. Throws InputError for the first thing that is wrong, most telling
/// first: an unknown key, with the nearest known one; then what is deepest in the document. The message gives the
/// source, the path as `--set` writes it, what is wrong and what is allowed.
void check_against_schema(const nlohmann::json& configuration, const std::string& source);

/// The same for a part of a configuration: what the schema calls by that name in its definitions, such as "descriptor".
void check_against_schema(const nlohmann::json& part, const std::string& definition, const std::string& source);

}  // namespace shapegauge
