// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Offset distance r of the offset surface of a shape, fixed or chosen for the shape. Lengths are fractions of the
/// bounding-box diagonal.
struct ChosenOffset {
  double offset = 0;  ///< offset distance r, a fraction of the bounding-box diagonal
  double gap = 0;     ///< radius of the widest gap (gap_sizes()), a fraction of the diagonal; 0 if none
  std::optional<AutomaticOffset> automatic;  ///< result of automatic_offset(); none for a fixed offset
};

/// Makes a ChosenOffset from the result of automatic_offset().
ChosenOffset chosen_automatically(const AutomaticOffset& automatic);

/// Returns the offset `fixed`, or automatic_offset() if `fixed` is absent, with the widest gap of the shape.
/// Throws InputError for a shape without extent.
ChosenOffset choose_offset(std::optional<double> fixed, const Shape& shape);

/// Returns the offset in the settings of a field, a fraction of the diagonal; nothing for a field without offset, or
/// one that chooses it for each shape ("auto").
std::optional<double> fixed_offset(const FieldSettings& field);

/// Returns the offset of the offset surface that a field uses on the shape of `source`; nothing if the field has none.
std::optional<ChosenOffset> offset_of(const FieldSettings& field, FieldSource& source);

/// Describes the gaps and noise that determined an automatic offset; returns an empty string for a fixed offset.
std::string reasons_for_offset(const ChosenOffset& chosen);

/// Returns a warning if the offset is smaller than the radius of the widest gap, through which the offset surface leaks
/// into the shape; otherwise nothing.
std::optional<std::string> leak_warning(const ChosenOffset& chosen);

/// Returns a remark on a hollow shape (closed_components()): whether values are the thickness of its outer hull (with
/// `measures_hull`, as for the offset SDF) or of its wall. Returns nothing for other shapes.
std::optional<std::string> hollow_remark(const Shape& shape, bool measures_hull);

}  // namespace shapegauge
