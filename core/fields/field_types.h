// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/fields/field.h"

/// Functions that make the built-in entries of field_types(); not part of the public interface.
namespace shapegauge {

FieldType offset_sdf_type();      ///< makes the field type of the SDF of the offset surface
FieldType cone_sdf_type();        ///< makes the field type of the SDF from rays in a cone
FieldType inscribed_ball_type();  ///< makes the field type of the wall thickness by inscribed balls
FieldType gap_type();             ///< makes the field type of the width of gaps: diameters of largest outer balls
FieldType centricity_type();      ///< makes the field type of geodesic centricity
FieldType heat_kernel_type();     ///< makes the field type of the heat kernel signature at one time
/// Makes the field type of one coefficient of the scale-invariant heat kernel signature.
FieldType scale_invariant_type();
FieldType wave_kernel_type();  ///< makes the field type of the wave kernel signature at one energy

}  // namespace shapegauge
