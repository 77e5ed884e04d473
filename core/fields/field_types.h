// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/fields/field.h"

/// Functions that make the built-in entries of field_types(); not part of the public interface.
namespace shapegauge {

FieldType offset_sdf_type();
FieldType cone_sdf_type();
FieldType inscribed_ball_type();
FieldType gap_type();
FieldType centricity_type();
FieldType heat_kernel_type();
FieldType scale_invariant_type();
FieldType wave_kernel_type();

}  // namespace shapegauge
