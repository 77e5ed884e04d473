#pragma once

#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The options with a view that follows the shape when it is moved or turned: its longest principal axis lies across
/// the image, its shortest points roughly at the viewer, who looks a little from the side and from above. The axes are
/// those of the second moments of the surface, or of a cloud's points; each points to where the shape reaches out
/// further (positive third moment), an axis about which the shape is balanced along its largest coordinate. The
/// options are returned as they are where the shape has no finite extent.
RenderOptions principal_view(const Shape& shape, RenderOptions options = {});

}  // namespace shapegauge
