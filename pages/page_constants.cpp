// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/page_constants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/shading.h"
#include "shapegauge/core/render/splats.h"
#include "shapegauge/pages/packed_numbers.h"
#include "shapegauge/pages/palette.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

namespace {

/// Formats the colour map in steps of 1/255 as an array over several lines.
std::string ramp_lines() {
  constexpr int colours = 256;
  constexpr int colours_a_line = 8;
  std::string lines;
  for (int level = 0; level < colours; ++level) {
    const bool first = level % colours_a_line == 0;
    const bool last = level % colours_a_line == colours_a_line - 1;
    lines +=
        fmt::format("{}'{}',{}", first ? "  " : " ", css_colour(colour_of(level / (colours - 1.0))), last ? "\n" : "");
  }
  return lines;
}

}  // namespace

std::string page_constants_script() {
  std::string script =
      "// Made by the target update_page_constants from the program's own constants (page_constants.cpp).\n\n";
  const auto add = [&](const char* comment, const char* name, const std::string& value) {
    script += fmt::format("// {}\nexport const {} = {};\n", comment, name, value);
  };
  add("Packed numbers: no value, the largest value, the largest coordinate of a direction.", "noLevel",
      fmt::format("{}", no_level));
  script +=
      fmt::format("export const topLevel = {};\nexport const directionLevels = {};\n", top_level, direction_levels);
  add("Number of the colours of methods.", "methodColours", fmt::format("{}", method_colours));
  add("Strokes and gaps of the lines of methods.", "methodDashes",
      fmt::format("['{}']", fmt::join(method_dashes, "', '")));
  add("Triangles of a point of a cloud.", "trianglesPerSplat", fmt::format("{}", triangles_per_splat));
  add("Edges up to this angle are shaded smoothly.", "smoothEdgeDegrees", fmt::format("{}", smooth_edge_degrees));
  add("Light of pictures: its direction (right, up, towards the viewer), and how much a surface has of it.", "shading",
      fmt::format("{{\n  light: [{}, {}, {}], wrap: {}, ambient: {}, wrapped: {}, frontal: {},\n}}", light_right,
                  light_up, light_towards, light_wrap, ambient_fraction, wrapped_fraction, frontal_fraction));
  add("Colours of no value, and of a shape without colours.", "unknownColour",
      fmt::format("'{}'", css_colour(colour_of(std::numeric_limits<double>::quiet_NaN()))));
  script += fmt::format("export const plainColour = '{}';\n", css_colour(plain_colour));
  add("Colour of values below a threshold.", "belowColour", fmt::format("'{}'", css_colour(below_threshold)));
  add("The colour map, from 0 to 1.", "ramp", fmt::format("[\n{}]", ramp_lines()));
  return script;
}

}  // namespace shapegauge
