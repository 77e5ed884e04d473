// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shapegauge/core/render/image.h"

namespace shapegauge {

/// Position in a drawing, right and down from its upper left corner, in points (1/72 inch).
using DrawingPoint = std::array<double, 2>;

/// Polyline or, if closed or filled, polygon of a drawing, with its fill and stroke.
struct DrawnPath {
  std::vector<DrawingPoint> points;   ///< corners, in order
  bool closed = false;                ///< true if the last point is connected to the first
  std::optional<Colour> fill = {};    ///< colour of the interior; absent for none
  std::optional<Colour> stroke = {};  ///< colour of the line; absent for none
  double width = 1;                   ///< width of the stroke in points
  std::vector<double> dashes = {};    ///< lengths of dashes and gaps in points; empty for a solid line
  double opacity = 1;                 ///< opacity of fill and stroke, from 0 (invisible) to 1
};

/// Point of a line of text that is at its position (DrawnText::position).
enum class TextAnchor { start, middle, end };

/// Line of text, positioned on the baseline at its start, middle or end.
struct DrawnText {
  std::string text;                       ///< one line of text in UTF-8
  DrawingPoint position;                  ///< position of the anchor, on the baseline
  double size = 11;                       ///< font size in points; the font is sans-serif
  Colour colour = {28, 34, 39};           ///< colour of the text
  TextAnchor anchor = TextAnchor::start;  ///< point of the text at `position`
  bool upwards = false;                   ///< true for text rotated to run from the bottom up
  bool bold = false;                      ///< true for a bold font
};

/// Vector drawing: paths and texts, drawn in order.
struct Drawing {
  double width = 0;                                          ///< width in points
  double height = 0;                                         ///< height in points
  std::vector<std::variant<DrawnPath, DrawnText>> elements;  ///< paths and texts; later ones cover earlier ones

  // Functions that add a path or text. `corner` is the upper left one; `width_of_line` is in points.
  void line(DrawingPoint from, DrawingPoint to, const Colour& stroke, double width_of_line = 1);
  void rectangle(DrawingPoint corner, DrawingPoint size, const Colour& fill);
  void path(DrawnPath path) { elements.emplace_back(std::move(path)); }
  void text(DrawnText text) { elements.emplace_back(std::move(text)); }
};

/// Estimates the width in points of a text of font size `size` from typical letter widths, for layout.
double estimated_text_width(std::string_view text, double size);

/// Returns the drawing as the contents of an SVG file, in which texts remain text.
std::string to_svg(const Drawing& drawing);

/// Returns the drawing as the bytes of a PDF file of one page with embedded fonts. The same drawing and fonts give the
/// same bytes.
std::string to_pdf(const Drawing& drawing);

/// Rasterises the drawing on white or, if `transparent`, on a transparent background.
Image to_image(const Drawing& drawing, double pixels_per_point = 2, bool transparent = false);

/// Throws InputError unless the name of a drawing's file ends in .svg, .pdf or .png.
void check_drawing_file(const std::filesystem::path& path);

/// Writes the drawing atomically; the name's extension selects the format: .svg, .pdf or .png (two pixels per point).
/// Throws as check_drawing_file() does, and InputError if the file cannot be written.
void write_drawing(const std::filesystem::path& path, const Drawing& drawing);

}  // namespace shapegauge
