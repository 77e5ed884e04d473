#pragma once

#include <cstddef>
#include <string>

#include "shapegauge/core/render/image.h"

namespace shapegauge {

/// Number of the colours of methods in charts. The next method has the first one again.
inline constexpr std::size_t method_colours = 7;

/// The colours of all pages as CSS: custom properties such as --paper and --method-0. They are light or dark as the
/// reader's system is, or as the attribute data-theme of the root element says.
std::string palette_style();

/// The colour as CSS and scripts have it: #rrggbb.
std::string css_colour(const Colour& colour);

}  // namespace shapegauge
