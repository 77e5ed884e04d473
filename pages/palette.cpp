// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/palette.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <stdexcept>

namespace shapegauge {

namespace {

struct PageColour {
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};

constexpr auto page_colours = std::to_array<PageColour>({
    {"paper", "#ffffff", "#14181b"},
    {"raised", "#f6f7f8", "#1d2327"},
    {"ink", "#1c2227", "#e8ebee"},
    {"muted", "#57616a", "#a3aeb7"},
    {"rule", "#d9dee2", "#39424a"},
    {"grid", "#e8ebed", "#2a3137"},
    {"accent", "#0b5fa5", "#71b7f2"},
    {"right", "#00705a", "#45cfa5"},
    {"wrong", "#b3470a", "#ff9d5c"},
});

constexpr auto colours_of_methods = std::to_array<PageColour>({
    {"blue", "#0b62ad", "#63b1f5"},
    {"orange", "#c44e00", "#ff9349"},
    {"green", "#007d5c", "#40cf9f"},
    {"purple", "#a23b8c", "#ea8fd5"},
    {"ochre", "#80630a", "#dfc04a"},
    {"sky", "#2b8bbd", "#a4dcff"},
    {"grey", "#5b6168", "#b9c1c8"},
});
static_assert(colours_of_methods.size() == method_colours);

/// Parses "#rrggbb".
Colour colour_of_css(std::string_view text) {
  Colour colour = {};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    std::from_chars(text.data() + 1 + 2 * k, text.data() + 3 + 2 * k, colour[k], 16);
  }
  return colour;
}

const PageColour& page_colour_named(std::string_view name) {
  const auto* const found = std::ranges::find(page_colours, name, &PageColour::name);
  if (found == page_colours.end()) throw std::out_of_range(fmt::format("no colour of pages is called {}", name));
  return *found;
}

std::string theme_rule(std::string_view selector, std::string_view theme, std::string_view PageColour::*colour) {
  std::string rule = fmt::format("{} {{\n  color-scheme: {};\n", selector, theme);
  for (const PageColour& one : page_colours) rule += fmt::format("  --{}: {};\n", one.name, one.*colour);
  // For shades of the accent, as rgba().
  const Colour accent = colour_of_css(page_colour_named("accent").*colour);
  rule += fmt::format("  --accent-channels: {}, {}, {};\n", accent[0], accent[1], accent[2]);
  for (std::size_t i = 0; i < colours_of_methods.size(); ++i) {
    rule += fmt::format("  --method-{}: {};\n", i, colours_of_methods[i].*colour);
  }
  return rule + "}\n";
}

}  // namespace

Colour method_colour(std::size_t index) { return colour_of_css(colours_of_methods[index % method_colours].light); }

Colour page_colour(std::string_view name) { return colour_of_css(page_colour_named(name).light); }

std::string palette_style() {
  return theme_rule(":root", "light", &PageColour::light) +
         theme_rule(":root[data-theme=\"dark\"]", "dark", &PageColour::dark) +
         "@media (prefers-color-scheme: dark) {\n" +
         theme_rule(":root:not([data-theme=\"light\"])", "dark", &PageColour::dark) + "}\n";
}

std::string css_colour(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

}  // namespace shapegauge
