// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/text.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/schema.h"

// The lists of docs/reference/configuration.md.

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// The text at a key, or nothing.
std::string text_at(const OrderedJson& object, const char* key) {
  return object.contains(key) ? object.at(key).get<std::string>() : std::string();
}

/// Name of the definition that a property refers to by "$ref", or nothing.
std::string referenced_definition(const OrderedJson& property) {
  const std::string reference = text_at(property, "$ref");
  return reference.substr(reference.find_last_of('/') + 1);
}

/// Legal values of a property and its default or "required"; nothing where the description says all.
std::vector<std::string> remarks_on(const OrderedJson& property, bool is_required) {
  std::vector<std::string> remarks;
  const std::string type = text_at(property, "type");
  if (const auto words = property.find("enum"); words != property.end()) {
    remarks.push_back(fmt::format("`{}`", fmt::join(words->get<std::vector<std::string>>(), "`, `")));
  } else if (type == "array" || type == "boolean") {
    remarks.emplace_back(type == "array" ? "list" : "true or false");
  }
  if (is_required) {
    remarks.emplace_back("required");
  } else if (property.contains("default")) {
    remarks.push_back(fmt::format("default `{}`", property["default"].dump()));
  }
  return remarks;
}

/// Lists the properties of an object's schema, except its parameters and properties without a description.
/// - `prefix`: precedes the keys.
std::string property_list(const OrderedJson& definitions, const OrderedJson& schema,
                          std::span<const Parameter> parameters, const std::string& prefix = {}) {
  const OrderedJson required = schema.value("required", OrderedJson::array());
  std::string list;
  for (const auto& [key, property] : schema.at("properties").items()) {
    const auto has_this_name = [&key = key](const Parameter& parameter) { return parameter.name == key; };
    if (std::ranges::any_of(parameters, has_this_name)) continue;
    const std::string reference = referenced_definition(property);
    OrderedJson full = reference.empty() ? property : definitions.at(reference);
    full.update(property);
    if (!full.contains("description")) continue;
    const bool is_required = std::ranges::find(required, OrderedJson(key)) != required.end();
    const std::vector<std::string> remarks = remarks_on(full, is_required);
    list += fmt::format("- `{}{}`{}: {}\n", prefix, key,
                        remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, "; ")),
                        text_at(full, "description"));
    if (reference.empty() && full.contains("then") && full["then"].contains("properties")) {
      list += property_list(definitions, full["then"], {}, prefix + key + ".");
    }
  }
  return list;
}

/// Lists the settings of a section of the schema: its properties, then its parameters.
std::string section_list(std::string_view section) {
  const std::string_view group =
      section == "segmentation_experiment" || !section.ends_with("_experiment") ? section : "experiment";
  const std::vector<ParameterGroup> groups = section_groups();
  const auto found = std::ranges::find(groups, group, &ParameterGroup::name);
  const std::span<const Parameter> parameters =
      found == groups.end() ? std::span<const Parameter>{} : found->parameters;
  const OrderedJson definitions = schema_definitions();
  const OrderedJson& schema = definitions.at(std::string(section));
  return property_list(definitions, schema.contains("properties") ? schema : schema.at("then"), parameters) +
         markdown_list(parameters);
}

/// The list without the items that `known` has, followed by a sentence that names their keys.
std::string without_known_items(std::string_view list, std::string_view known, std::string_view where) {
  std::string items;
  std::vector<std::string_view> keys;
  for (const std::string_view line : split_lines(list)) {
    if (line.starts_with("- `") && known.find(line) != std::string_view::npos) {
      keys.push_back(line.substr(2, line.find('`', 3) - 1));
    } else {
      items += fmt::format("{}\n", line);
    }
  }
  if (keys.empty()) return std::string(list);
  return fmt::format("{}{}{}: {}.\n", items, items.ends_with("\n\n") ? "" : "\n", where, fmt::join(keys, ", "));
}

/// - `key`: the setting that names the group.
std::string reference_list(const ParameterGroup& group, std::string_view key) {
  if (group.description.empty()) return markdown_list(group.parameters);
  std::string text = fmt::format("`\"{}\": \"{}\"`. {}\n", key, group.name, group.description);
  if (!group.parameters.empty()) text += "\n" + markdown_list(group.parameters);
  if (!group.axis_parameters.empty()) text += "\nEach of its `axes`:\n\n" + markdown_list(group.axis_parameters);
  return text;
}

std::string reference_lists(std::string_view name) {
  const std::map<std::string_view, std::vector<ParameterGroup>> lists{{"fields", field_groups()},
                                                                      {"perturbations", perturbation_groups()},
                                                                      {"descriptors", descriptor_groups()},
                                                                      {"rerank", rerank_groups()}};
  const auto list = lists.find(name);
  if (list == lists.end()) {
    const bool is_other_kind = name == "comparison_experiment" || name == "segmentation_experiment";
    return is_other_kind ? without_known_items(section_list(name), section_list("retrieval_experiment"),
                                               "As in a retrieval experiment")
                         : section_list(name);
  }
  std::string text;
  for (const ParameterGroup& group : list->second) {
    if (!text.empty()) text += '\n';
    text += without_known_items(reference_list(group, name == "rerank" ? "method" : "type"), text, "As above");
  }
  return text;
}

}  // namespace

std::string with_reference_lists(std::string_view page) {
  constexpr std::string_view opening = "<!-- list: ";
  constexpr std::string_view closing = " -->\n";
  constexpr std::string_view ending = "<!-- end -->\n";
  std::string filled;
  for (auto begin = page.find(opening); begin != std::string_view::npos; begin = page.find(opening)) {
    const std::size_t name = begin + opening.size();
    const std::size_t content = page.find(closing, name) + closing.size();
    filled += page.substr(0, content);
    filled += '\n';
    filled += reference_lists(page.substr(name, content - closing.size() - name));
    filled += '\n';
    page.remove_prefix(page.find(ending, content));
  }
  return filled.append(page);
}

}  // namespace shapegauge
