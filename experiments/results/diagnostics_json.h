#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/core/shape/diagnostics.h"

namespace shapegauge {

/// The diagnostics by name, as ShapeDiagnostics has them; `boundary_fraction`, `gap_fraction` and
/// `noise_fraction` are lengths over the diagonal, or 0 where there is none.
nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics);

}  // namespace shapegauge
