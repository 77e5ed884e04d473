// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Camera and image settings. The shape fills the image whatever its size and position.
struct RenderOptions {
  int width = 640;                                  ///< width of the image in pixels
  int height = 480;                                 ///< height of the image in pixels
  Eigen::Vector3d towards_viewer = {0.6, 0.45, 1};  ///< direction from the shape to the viewer; any length but 0
  Eigen::Vector3d up = {0, 1, 0};                   ///< direction that is vertical in the image; any length but 0
  double margin = 0.04;                             ///< fraction of the width and height left empty on every side
  int rays_per_side = 3;     ///< square root of the number of rays per pixel, whose mean is the pixel's colour
  bool transparent = false;  ///< transparent background instead of white
};

/// Returns the front direction of shapes whose vertical direction is `up`: -y if `up` is z or -z, otherwise z,
/// projected to the horizontal plane.
Eigen::Vector3d front_of(const Eigen::Vector3d& up);

/// Returns the options with a view in which the shape stands upright: `options.up` is vertical, and the camera is
/// slightly above and to the side of the shape's broad side. That is the side along which the horizontal second moments
/// of the surface, or of a cloud's points, are largest. Of the two broad sides, the one closer to front_of() is shown,
/// as is the front of a shape without a broad side.
RenderOptions upright_view(const Shape& shape, RenderOptions options);

/// Image plane of a parallel projection, in front of the shape.
struct Camera {
  Eigen::Vector3d top_left;  ///< position of the top left corner of the image, in the shape's coordinates
  Eigen::Vector3d right;     ///< unit vector to the right in the image
  Eigen::Vector3d up;        ///< unit vector upwards in the image
  Eigen::Vector3d forward;   ///< unit vector away from the viewer
  Eigen::Vector3d light;     ///< unit vector towards the light: above the viewer's left shoulder
  double pixel = 0;          ///< side of a pixel in the shape's units

  /// Returns the position at a pixel's coordinates (column and row from the top left, fractional) and a depth behind
  /// the image plane.
  [[nodiscard]] Eigen::Vector3d at(double column, double row, double depth) const {
    return top_left + pixel * (column * right - row * up) + depth * forward;
  }
};

/// Computes the camera for a shape, which must have an extent. Throws InputError for an option out of range.
Camera camera_for(const Shape& shape, const RenderOptions& options);

}  // namespace shapegauge
