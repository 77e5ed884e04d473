// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "shapegauge/core/render/image.h"

namespace shapegauge {

/// Number of distinct colours of methods in charts; further methods repeat them cyclically.
inline constexpr std::size_t method_colours = 7;

/// Dash patterns of the lines of methods in charts, in SVG notation; "none" for a solid line. They distinguish methods
/// of the same colour.
inline constexpr std::array<std::string_view, 7> method_dashes{"none", "7 3",         "2 3", "9 3 2 3",
                                                               "12 4", "5 2 1 2 1 2", "3 2"};

/// Returns the index into a list of `count` dashes or symbols for the method `index`. With each cycle of colours, the
/// indices shift by one, so that methods of one colour have different dashes and symbols.
constexpr std::size_t dash_or_symbol_index(std::size_t index, std::size_t count) {
  return (index + index / method_colours) % count;
}

/// Returns the light-theme colour of the method with this index, from 0 on.
Colour method_colour(std::size_t index);

/// Returns a light-theme colour of pages by name, such as "ink" or "grid". Throws std::out_of_range for an unknown
/// name.
Colour page_colour(std::string_view name);

/// Returns the colours of all pages as CSS: custom properties such as --paper and --method-0. They follow the reader's
/// light or dark system theme, or the attribute data-theme of the root element.
std::string palette_style();

/// Formats a colour for CSS and scripts, such as "\#12ab9f".
std::string css_colour(const Colour& colour);

}  // namespace shapegauge
