// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "shapegauge/core/render/camera.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Renders a shape in parallel projection, lit from above the viewer's left shoulder. Both sides of a triangle look the
/// same; edges of up to 40 degrees are shaded smoothly. `colours` has one colour per triangle, or one per vertex to
/// interpolate within triangles, according to `site`. A point cloud is drawn as splats() in the colours of its points.
/// The same input gives the same bytes on any number of threads. Throws InputError if there is nothing to draw, for a
/// wrong number of colours, and for an option out of range.
Image render_shape(const Shape& shape, const std::vector<Colour>& colours, SampleSite site,
                   const RenderOptions& options = {});

}  // namespace shapegauge
