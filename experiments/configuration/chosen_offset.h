// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Offset for measuring a shape. Lengths are fractions of the bounding-box diagonal.
struct ChosenOffset {
  double offset = 0;
  double gap = 0;                            ///< radius of the widest gap of the shape (gap_sizes())
  std::optional<AutomaticOffset> automatic;  ///< the choice made for "auto"
};

/// Converts the result of automatic_offset().
ChosenOffset chosen_automatically(const AutomaticOffset& automatic);

/// Returns the given offset or, without one, automatic_offset(). Throws InputError for a shape without extent.
ChosenOffset choose_offset(std::optional<double> given, const Shape& shape);

/// Returns the offset of a field's settings; nothing for a field without one, or that chooses it for each shape.
std::optional<double> fixed_offset(const FieldSettings& field);

/// Returns the offset of a field on the shape; nothing for a field without one.
std::optional<ChosenOffset> offset_of(const FieldSettings& field, FieldSource& source);

/// Returns the reasons for an automatically chosen offset; empty for a given one.
std::string reasons_for_offset(const ChosenOffset& chosen);

/// Returns the warning about an offset smaller than the gaps of the shape, if it is.
std::optional<std::string> leak_warning(const ChosenOffset& chosen);

/// Says of a hollow body (closed_components()) whether values are those of its hull, as the offset SDF computes them,
/// or of its wall. Nothing for other shapes.
std::optional<std::string> hollow_remark(const Shape& shape, bool measures_hull);

}  // namespace shapegauge
