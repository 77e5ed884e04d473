#pragma once

#include <vector>

#include "shapegauge/core/render/camera.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Renders a shape in parallel projection, lit from above the viewer's left shoulder. Both sides of a triangle are
/// drawn alike; edges up to 40 degrees are shaded smoothly. `colours` has one colour a triangle, or one a vertex to
/// blend within triangles, as `site` says. Of a point cloud, splats() are drawn, each in the colour of its vertex. The
/// same input gives the same bytes, on any number of threads. Throws InputError where there is nothing to draw, the
/// number of colours is wrong, or an option is out of range.
Image render_shape(const Shape& shape, const std::vector<Colour>& colours, SampleSite site,
                   const RenderOptions& options = {});

}  // namespace shapegauge
