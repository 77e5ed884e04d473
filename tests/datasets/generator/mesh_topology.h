#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// What keeps a mesh from being closed, 2-manifold, consistently oriented outward and of one component, found by
/// counting edges and walking around vertices; empty where nothing does.
std::string topology_fault(const Shape& mesh);

}  // namespace shapegauge
