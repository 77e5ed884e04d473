// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Lighting of images and interactive views: a directional light with wrap lighting (light_wrap) from above the
/// viewer's left shoulder, and a weak one from the viewer.

namespace shapegauge {

inline constexpr double smooth_edge_degrees = 40;  ///< maximum angle between the faces' normals at a smooth edge

// Direction to the light in the viewer's axes, not normalised.
inline constexpr double light_right = -0.6;   ///< component of the direction to the light, to the viewer's right
inline constexpr double light_up = 1;         ///< component of the direction to the light, upwards in the image
inline constexpr double light_towards = 0.9;  ///< component of the direction to the light, towards the viewer

/// Extent of wrap lighting: surfaces with dot(normal, direction to the light) > -light_wrap are lit.
inline constexpr double light_wrap = 0.6;
inline constexpr double ambient_fraction = 0.36;  ///< fraction of a surface's colour that is shown without any light
/// Fraction of a surface's colour added by the light with wrap lighting if the surface faces it.
inline constexpr double wrapped_fraction = 0.54;
/// Fraction of a surface's colour added by the light from the viewer if the surface faces the viewer.
inline constexpr double frontal_fraction = 0.1;

}  // namespace shapegauge
