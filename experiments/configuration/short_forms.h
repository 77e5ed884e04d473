// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace shapegauge {

/// Replaces the short forms in a document, which may be invalid: names in place of objects (`"field": "cone_sdf"`,
/// `"descriptor": "d2"`, `"sum": ["a", "b"]`), and `defaults`, by settings of each field that lacks them.
void expand_short_forms(nlohmann::json& document);

}  // namespace shapegauge
