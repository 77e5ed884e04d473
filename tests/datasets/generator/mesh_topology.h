// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Reason why a mesh is not closed, 2-manifold, consistently oriented outward and connected, found by
/// counting edges and walking around vertices; empty if there is none.
std::string topology_fault(const Shape& mesh);

}  // namespace shapegauge
