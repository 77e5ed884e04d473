// Settings of registries and tables of options, for defaults and docstrings of the Python package.
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "python/native.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/metrics/method_comparison.h"

namespace py = pybind11;

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// Each parameter's meaning, legal values and default (null: required), by its name.
OrderedJson listed_parameters(std::span<const Parameter> parameters) {
  const nlohmann::json defaults = to_json(ParameterValues(parameters));
  OrderedJson listed = OrderedJson::object();
  for (const Parameter& parameter : parameters) {
    const std::string name(parameter.name);
    listed[name] = {{"meaning", parameter.description},
                    {"values", legal_values(parameter)},
                    {"default", OrderedJson::parse(defaults.at(name).dump())}};
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

/// Defaults of options that no registry has, by function and argument.
OrderedJson other_defaults() {
  const ComparisonOptions comparison;
  return {{"sdf", {{"offset", OffsetSdfOptions{}.offset}}},
          {"compare",
           {{"test", name_of(comparison.test)},
            {"blocks", name_of(comparison.blocks)},
            {"confidence", comparison.confidence},
            {"resamples", comparison.resampling.resamples},
            {"seed", comparison.resampling.seed}}}};
}

}  // namespace

void bind_settings(py::module_& module) {
  module.def("settings", [] {
    return OrderedJson{{"fields", listed_groups(field_groups())},
                       {"descriptors", listed_groups(descriptor_groups())},
                       {"rerank", listed_groups(rerank_groups())},
                       {"sections", listed_groups(section_groups())},
                       {"defaults", other_defaults()}}
        .dump();
  });
}

}  // namespace shapegauge
