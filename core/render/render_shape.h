#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/render/colour_map.h"
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

/// Picture of a shape in parallel projection, lit from above the viewer's left shoulder. Both sides of a triangle are
/// drawn alike; edges up to 40 degrees are shaded smoothly. `colours` has one colour a triangle, or one a vertex to
/// blend within triangles, as `site` says. Of a point cloud, splats() are drawn, each in the colour of its vertex. The
/// same input gives the same bytes, on any number of threads. Throws InputError where there is nothing to draw, the
/// number of colours is wrong, or an option is out of range.
Image render_shape(const Shape& shape, const std::vector<Colour>& colours, SampleSite site,
                   const RenderOptions& options = {});

}  // namespace shapegauge
