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

inline constexpr double light_wrap = 0.6;         ///< the light reaches surfaces where dot(normal, light) > -light_wrap
inline constexpr double ambient_fraction = 0.36;  ///< fraction of the colour that remains without light
inline constexpr double wrapped_fraction = 0.54;  ///< fraction of the colour added where the light is perpendicular
inline constexpr double frontal_fraction = 0.1;   ///< fraction of the colour added on a surface that faces the viewer

}  // namespace shapegauge
