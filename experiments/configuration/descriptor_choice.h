// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Descriptor chosen by a configuration, with the fields that it is computed from.
struct DescriptorChoice {
  Descriptor descriptor;
  DescriptorSettings values;
  std::vector<Field> fields;  ///< all at the same samples
};

/// Makes the descriptor with the given settings. "type" is its name, "fields" lists its fields, if any, and "axes" the
/// settings for each field. Throws InputError for a type that is not in descriptors(), and ConfigurationError with the
/// path for invalid settings: too few or too many fields, fields at different samples.
DescriptorChoice make_descriptor(const nlohmann::json& settings);

/// Formats the settings as make_descriptor() takes them, including those of fields and axes, with all defaults.
nlohmann::json to_json(const DescriptorChoice& choice);

/// Returns true if the descriptor must learn from all shapes before it can describe one.
bool needs_learning(const DescriptorChoice& choice);

/// Fields of a descriptor on a shape.
struct DescriptorFields {
  std::vector<ScalarField> fields;
  /// Each once: samples without a usable value (outcome_warnings()), an offset smaller than the gaps of the shape
  /// (leak_warning()), a hollow shape, whose hull is measured (hollow_remark()).
  std::vector<std::string> warnings;
};

/// Computes the descriptor's fields on a prepared shape. Throws InputError as the fields do.
DescriptorFields compute_fields(const DescriptorChoice& choice, FieldSource& source);

}  // namespace shapegauge
