#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// A descriptor that a configuration asks for, and the fields that it is computed from.
struct DescriptorChoice {
  nlohmann::json settings;  ///< type and all settings, those of fields and axes too, defaults filled in
  Descriptor descriptor;
  DescriptorSettings values;
  std::vector<Field> fields;  ///< all at the same samples
};

/// The descriptor that the settings describe, by their "type"; "fields" lists the fields of one that takes some, and
/// "axes" the settings of each. Throws InputError for a type that is not in descriptors(), and ConfigurationError with
/// the place for settings that it does not take: too few or too many fields, fields at different samples.
DescriptorChoice make_descriptor(const nlohmann::json& settings);

/// The fields that the descriptor is computed from, of a prepared shape. Throws InputError as they do.
std::vector<ScalarField> compute_fields(const DescriptorChoice& choice, FieldSource& source);

}  // namespace shapegauge
