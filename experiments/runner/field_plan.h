#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// A field to compute on every shape, and who uses it.
struct PlannedField {
  Field field;
  std::vector<std::size_t> signatures;  ///< indices of the signatures that are histograms of it
  bool keep_values = false;             ///< a histogram over the whole data set's range has to wait for all shapes
};

/// The distinct fields of the signatures, in order of first use: fields of equal settings are computed once.
std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures);

/// Whether it is the field that colours the models in the report.
bool is_pictured(const PlannedField& planned, const ReportConfiguration& report);

}  // namespace shapegauge
