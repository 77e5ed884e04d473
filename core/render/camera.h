#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Camera and image settings. The shape fills the image whatever its size and place.
struct RenderOptions {
  int width = 640;                                  ///< pixels
  int height = 480;                                 ///< pixels
  Eigen::Vector3d towards_viewer = {0.6, 0.45, 1};  ///< direction from the shape to the viewer; any length but 0
  Eigen::Vector3d up = {0, 1, 0};                   ///< direction that is upright in the image; any length but 0
  double margin = 0.04;                             ///< part of the width and of the height left free on every side
  int rays_per_side = 3;                            ///< a pixel is the mean of a square grid of this many rays a side
  bool transparent = false;                         ///< transparent background instead of white
};

/// The options with a view that moves and turns with the shape: its longest principal axis lies across
/// the image, its shortest points roughly at the viewer, who looks a little from the side and from above. The axes are
/// those of the second moments of the surface, or of a cloud's points; each points to where the shape reaches out
/// further (positive third moment), an axis about which the shape is balanced along its largest coordinate. The
/// options are returned as they are where the shape has no finite extent.
RenderOptions principal_view(const Shape& shape, RenderOptions options = {});

/// The image plane of a parallel projection, in front of the shape.
struct Camera {
  Eigen::Vector3d top_left;  ///< corner of the image
  Eigen::Vector3d right;     ///< unit
  Eigen::Vector3d up;        ///< unit
  Eigen::Vector3d forward;   ///< unit, away from the viewer
  Eigen::Vector3d light;     ///< unit, to where the light comes from: above the viewer's left shoulder
  double pixel = 0;          ///< side of a pixel in the shape's units

  [[nodiscard]] Eigen::Vector3d at(double column, double row, double depth) const {
    return top_left + pixel * (column * right - row * up) + depth * forward;
  }
};

/// The camera of the options, in front of a mesh that has an extent. Throws InputError where an option is out of range.
Camera camera_for(const Shape& shape, const RenderOptions& options);

}  // namespace shapegauge
