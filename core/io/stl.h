#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The shape in the bytes of an STL file, ASCII or binary (also where its free header begins with "solid"). Corners
/// with equal coordinates become one vertex, in the order of their first appearance: the format has no indices. Normals
/// and attributes are passed over.
///
/// `name` stands in front of messages. Throws InputError, with the line or the facet: truncated, coordinate that is not
/// finite.
Shape read_stl(const std::string& bytes, const std::string& name);

/// Throws InputError where the bytes do not begin like an STL file.
void check_stl_header(const std::string& bytes, const std::string& name);

}  // namespace shapegauge
