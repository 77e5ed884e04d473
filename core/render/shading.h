// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Lighting of images and interactive views: a wrapped light from above the viewer's left shoulder, and a weak one from
/// the viewer.

namespace shapegauge {

inline constexpr double smooth_edge_degrees = 40;  ///< edges up to this angle are shaded smoothly

/// Direction to the light in the viewer's axes, not normalised.
/// @{
inline constexpr double light_right = -0.6;
inline constexpr double light_up = 1;
inline constexpr double light_towards = 0.9;
/// @}

inline constexpr double light_wrap = 0.6;  ///< cosine of the angle beyond 90 degrees that the light still reaches
inline constexpr double ambient_fraction = 0.36;  ///< fraction of the colour without light
inline constexpr double wrapped_fraction = 0.54;  ///< fraction of the colour added where the light falls vertically
inline constexpr double frontal_fraction = 0.1;   ///< fraction of the colour added on a surface that faces the viewer

}  // namespace shapegauge
