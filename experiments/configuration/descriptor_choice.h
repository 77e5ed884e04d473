// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Descriptor chosen by a configuration, with its settings and the fields that its features are computed from.
struct DescriptorChoice {
  Descriptor descriptor;      ///< descriptor, one of descriptors()
  DescriptorSettings values;  ///< settings of the descriptor
  std::vector<Field> fields;  ///< fields that the features are computed from, all at the same samples
};

/// Makes a descriptor from its settings. "type" is its name, "fields" lists its fields, if any, and "axes" the
/// settings for each field. Throws InputError for a type that is not in descriptors(), and ConfigurationError with the
/// path of the value for invalid settings: too few or too many fields, fields at different samples.
DescriptorChoice make_descriptor(const nlohmann::json& settings);

/// Formats the settings of a descriptor as make_descriptor() reads them, including those of fields and axes, with all
/// defaults.
nlohmann::json to_json(const DescriptorChoice& choice);

/// Returns true if the descriptor must learn from all shapes of a data set before it can describe one of them.
bool needs_learning(const DescriptorChoice& choice);

/// Values of the fields of a descriptor on one shape, with warnings about them.
struct DescriptorFields {
  std::vector<ScalarField> fields;  ///< values of each field at its samples
  /// Distinct warnings: samples without a usable value (outcome_warnings()), an offset smaller than the gaps of the
  /// shape (leak_warning()), a hollow shape, whose hull is measured (hollow_remark()).
  std::vector<std::string> warnings;
};

/// Computes the fields of a descriptor on a prepared shape. Throws InputError as Field::compute() does.
DescriptorFields compute_fields(const DescriptorChoice& choice, FieldSource& source);

}  // namespace shapegauge
