#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "shapegauge/experiments/shape_comparison/measure_shape.h"

/// Records of measured shapes, for the cache and for other processes. Reading restores everything bit by bit.

namespace shapegauge {

/// Record of a shape, as those of cache_records.h. `plan` are the fields of the comparison.
/// @{
nlohmann::json measured_record(const MeasuredShape& measured);
MeasuredShape read_measured_record(const nlohmann::json& record, std::span<const PlannedField> plan);
/// @}

/// Serialise the record for another process of the same run.
/// @{
std::string measured_bytes(const MeasuredShape& measured);
MeasuredShape read_measured_bytes(std::string_view bytes, std::span<const PlannedField> plan);
/// @}

}  // namespace shapegauge
