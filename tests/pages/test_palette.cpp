// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <string>

#include "shapegauge/pages/palette.h"

namespace shapegauge {
namespace {

/// The custom properties that a rule of the palette sets.
std::set<std::string> properties(const std::string& rule) {
  static const std::regex property("--[a-z0-9-]+(?=:)");
  return {std::sregex_token_iterator(rule.begin(), rule.end(), property), std::sregex_token_iterator()};
}

TEST(PagePalette, LightAndDarkThemesDefineTheSameCssProperties) {
  const std::string style = palette_style();
  const std::size_t dark = style.find(":root[data-theme=\"dark\"]");
  const std::size_t system = style.find("@media (prefers-color-scheme: dark)");
  ASSERT_LT(dark, system);
  const std::set<std::string> light = properties(style.substr(0, dark));
  EXPECT_EQ(properties(style.substr(dark, system - dark)), light);
  EXPECT_EQ(properties(style.substr(system)), light);
  EXPECT_TRUE(light.contains("--method-" + std::to_string(method_colours - 1)));
  EXPECT_FALSE(light.contains("--method-" + std::to_string(method_colours)));
}

/// Contrast of two colours (WCAG 2.1), from 1 to 21.
double contrast(const std::string& style, const std::string& first, const std::string& second) {
  const auto luminance = [&](const std::string& name) {
    const std::size_t at = style.find("--" + name + ": #") + name.size() + 5;
    const auto channel = [&](std::size_t k) {
      const double part = std::stoi(style.substr(at + 2 * k, 2), nullptr, 16) / 255.0;
      return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2) + 0.05;
  };
  const double ratio = luminance(first) / luminance(second);
  return std::max(ratio, 1 / ratio);
}

TEST(PagePalette, ColoursHaveSufficientContrastWithTheBackground) {
  const std::string style = palette_style();
  const std::string dark = style.substr(style.find(":root[data-theme=\"dark\"]"));
  for (const std::string& theme : {style, dark}) {
    EXPECT_GE(contrast(theme, "ink", "paper"), 7);      // WCAG's AAA for text
    EXPECT_GE(contrast(theme, "muted", "paper"), 4.5);  // AA for text
    for (std::size_t i = 0; i < method_colours; ++i) {
      EXPECT_GE(contrast(theme, "method-" + std::to_string(i), "paper"), 3);  // AA for graphics
    }
  }
}

TEST(PagePalette, RgbChannelsMatchTheAccentColour) {
  const std::string style = palette_style();
  static const std::regex accents("--accent: #(..)(..)(..);[^}]*--accent-channels: (\\d+), (\\d+), (\\d+);");
  int themes = 0;
  for (std::sregex_iterator found(style.begin(), style.end(), accents), none; found != none; ++found, ++themes) {
    for (std::size_t k = 1; k <= 3; ++k) {
      EXPECT_EQ(std::stoi((*found)[k], nullptr, 16), std::stoi((*found)[k + 3])) << found->str();
    }
  }
  EXPECT_EQ(themes, 3);
}

TEST(CssColour, HasTwoHexadecimalDigitsPerChannel) { EXPECT_EQ(css_colour({0, 10, 255}), "#000aff"); }

}  // namespace
}  // namespace shapegauge
