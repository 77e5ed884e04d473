// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of registries and tables of options, for defaults and docstrings of the Python package.
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "python/native.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/kinds/experiment_kinds.h"
#include "shapegauge/experiments/search/search.h"
#include "shapegauge/metrics/method_comparison.h"

namespace py = pybind11;

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// Each parameter's meaning, legal values, bounds (of numbers) and default (null: required), by its name.
OrderedJson listed_parameters(std::span<const Parameter> parameters) {
  const nlohmann::json defaults = to_json(ParameterValues(parameters));
  OrderedJson listed = OrderedJson::object();
  for (const Parameter& parameter : parameters) {
    const std::string name(parameter.name);
    listed[name] = {{"meaning", parameter.description},
                    {"values", legal_values(parameter)},
                    {"default", OrderedJson::parse(defaults.at(name).dump())}};
    const Bounds& bounds = parameter.bounds;
    if (std::isfinite(bounds.low) && std::isfinite(bounds.high)) listed[name]["bounds"] = {bounds.low, bounds.high};
  }
  return listed;
}

OrderedJson listed_groups(const std::vector<ParameterGroup>& groups) {
  OrderedJson listed = OrderedJson::object();
  for (const ParameterGroup& group : groups) {
    listed[std::string(group.name)] = {{"meaning", group.description},
                                       {"settings", listed_parameters(group.parameters)}};
  }
  return listed;
}

/// The types of fields; `is_thickness` for the methods of sdf().
OrderedJson listed_fields() {
  OrderedJson listed = listed_groups(field_groups());
  for (const FieldType& type : field_types().entries()) listed[type.name]["is_thickness"] = type.is_thickness;
  return listed;
}

/// Options that configurations do not have, by function.
OrderedJson other_options() {
  return {{"sdf", listed_parameters(parameters_of(offset_sdf_table))},
          {"compare", listed_parameters(parameters_of(comparison_table))},
          {"search", listed_parameters(parameters_of(search_table))}};
}

/// Names and descriptions of the kinds of experiments.
OrderedJson listed_experiments() {
  OrderedJson listed = OrderedJson::object();
  for (const ExperimentKind& kind : experiment_kinds().entries()) listed[std::string(kind.name)] = kind.description;
  return listed;
}

}  // namespace

void bind_settings(py::module_& module) {
  module.attr("most_threads") = static_cast<int>(threads_bounds.high);
  module.def("settings", [] {
    return OrderedJson{{"fields", listed_fields()},
                       {"descriptors", listed_groups(descriptor_groups())},
                       {"rerank", listed_groups(rerank_groups())},
                       {"sections", listed_groups(section_groups())},
                       {"options", other_options()},
                       {"experiments", listed_experiments()}}
        .dump();
  });
}

}  // namespace shapegauge
