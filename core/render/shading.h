#pragma once

/// How surfaces are lit, in pictures and in the interactive views of pages: light from above the viewer's left shoulder
/// that wraps around the form, and a little from the viewer.

namespace shapegauge {

inline constexpr double smooth_edge_degrees = 40;  ///< edges up to this angle are shaded smoothly

/// Direction to the light, in the viewer's axes; not of unit length.
/// @{
inline constexpr double light_right = -0.6;
inline constexpr double light_up = 1;
inline constexpr double light_towards = 0.9;
/// @}

inline constexpr double light_wrap = 0.6;     ///< cosine beyond 90 degrees that the light still reaches
inline constexpr double ambient_part = 0.36;  ///< of the colour that is seen without light
inline constexpr double wrapped_part = 0.54;  ///< of the colour that the light adds where it falls vertically
inline constexpr double frontal_part = 0.1;   ///< of the colour that a surface facing the viewer adds

}  // namespace shapegauge
