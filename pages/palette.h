#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "shapegauge/core/render/image.h"

namespace shapegauge {

/// Number of the colours of methods in charts. The next method has the first one again.
inline constexpr std::size_t method_colours = 7;

/// Strokes and gaps of the lines of methods in charts, as in SVG; "none": unbroken. Methods of one colour differ in
/// them.
inline constexpr std::array<std::string_view, 7> method_dashes{"none", "7 3",         "2 3", "9 3 2 3",
                                                               "12 4", "5 2 1 2 1 2", "3 2"};

/// The place of the i-th method in a list of so many dashes or signs: one further with each round of the colours.
constexpr std::size_t shifted_method(std::size_t index, std::size_t count) {
  return (index + index / method_colours) % count;
}

/// The light colour of the i-th method.
Colour method_colour(std::size_t index);

/// The light colour of that name among those of pages ("ink", "grid"). Throws std::out_of_range for another name.
Colour page_colour(std::string_view name);

/// The colours of all pages as CSS: custom properties such as --paper and --method-0. They are light or dark as the
/// reader's system is, or as the attribute data-theme of the root element says.
std::string palette_style();

/// The colour as CSS and scripts have it: #rrggbb.
std::string css_colour(const Colour& colour);

}  // namespace shapegauge
