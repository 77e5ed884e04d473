// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace shapegauge {

/// Expands the short forms in a document, which may be invalid. A name becomes an object (`"field": "cone_sdf"`,
/// `"descriptor": "d2"`, `"sum": ["a", "b"]`). The settings in "defaults" are copied to each field that lacks them.
void expand_short_forms(nlohmann::json& document);

}  // namespace shapegauge
