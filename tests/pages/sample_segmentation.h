// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/pages/segmentation_page.h"

namespace shapegauge::test_segmentation {

/// A page whose names are markup, with two shapes of two classes, two methods and one error that is not defined. Only
/// the first shape has a view, with the parts of a reference and of a method.
SegmentationPage sample_page();

}  // namespace shapegauge::test_segmentation
