#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How a shape is looked at. The shape fills the image whatever its size and place.
struct RenderOptions {
  int width = 640;                                  ///< pixels
  int height = 480;                                 ///< pixels
  Eigen::Vector3d towards_viewer = {0.6, 0.45, 1};  ///< direction from the shape to the viewer; any length but 0
  Eigen::Vector3d up = {0, 1, 0};                   ///< direction that is upright in the image; any length but 0
  double margin = 0.04;                             ///< part of the width and of the height left free on every side
  int rays_per_side = 3;                            ///< a pixel is the mean of a square grid of this many rays a side
  bool transparent = false;                         ///< transparent background instead of white
};

/// Renders a shape in parallel projection, lit from above the viewer's left shoulder. Both sides of a triangle are
/// drawn alike; edges up to 40 degrees are shaded smoothly. `colours` has one colour a triangle, or one a vertex to
/// blend within triangles, as `site` says. Of a point cloud, splats() are drawn, each in the colour of its vertex. The
/// same input gives the same bytes, on any number of threads. Throws InputError where there is nothing to draw, the
/// number of colours is wrong, or an option is out of range.
Image render_shape(const Shape& shape, const std::vector<Colour>& colours, SampleSite site,
                   const RenderOptions& options = {});

/// The options with a view that moves and turns with the shape: its longest principal axis lies across
/// the image, its shortest points roughly at the viewer, who looks a little from the side and from above. The axes are
/// those of the second moments of the surface, or of a cloud's points; each points to where the shape reaches out
/// further (positive third moment), an axis about which the shape is balanced along its largest coordinate. The
/// options are returned as they are where the shape has no finite extent.
RenderOptions principal_view(const Shape& shape, RenderOptions options = {});

/// The number of triangles of a splat.
constexpr int triangles_per_splat = 4;

/// A mesh that looks like the surface a point cloud lies on: at each point a hexagon in the tangent plane, so large
/// that hexagons overlap where the points are spread at random; triangle f belongs to point f / triangles_per_splat.
/// The plane is that of the point's normal or, without one, of its 12 nearest neighbours. Of no size where all points
/// are at one place. Throws as point_weights().
Shape splats(const Shape& cloud);

}  // namespace shapegauge
