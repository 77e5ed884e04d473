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

/// A place in a drawing, from its upper left corner, right and down, in points (1/72 inch).
using DrawingPoint = std::array<double, 2>;

/// A line through points, or the area within it.
struct DrawnPath {
  std::vector<DrawingPoint> points;
  bool closed = false;
  std::optional<Colour> fill = {};
  std::optional<Colour> stroke = {};
  double width = 1;                 ///< of the stroke
  std::vector<double> dashes = {};  ///< lengths of strokes and gaps; empty: unbroken
  double opacity = 1;
};

enum class TextAnchor { start, middle, end };

/// A line of text. Its place is on the baseline, at the text's start, middle or end.
struct DrawnText {
  std::string text;  ///< UTF-8
  DrawingPoint place;
  double size = 11;  ///< of the font, which is sans-serif
  Colour colour = {28, 34, 39};
  TextAnchor anchor = TextAnchor::start;
  bool upwards = false;  ///< turned to run from the bottom up
  bool bold = false;
};

/// A vector drawing: paths and texts, later ones in front.
struct Drawing {
  double width = 0;
  double height = 0;
  std::vector<std::variant<DrawnPath, DrawnText>> elements;

  void line(DrawingPoint from, DrawingPoint to, const Colour& stroke, double width_of_line = 1);
  void rectangle(DrawingPoint corner, DrawingPoint size, const Colour& fill);
  void path(DrawnPath path) { elements.emplace_back(std::move(path)); }
  void text(DrawnText text) { elements.emplace_back(std::move(text)); }
};

/// Width of a text in points, estimated from the letters' usual widths: exact enough to keep room for it.
double estimated_text_width(std::string_view text, double size);

/// The drawing as an SVG file with text as text.
std::string to_svg(const Drawing& drawing);

/// The drawing as a PDF file of one page with embedded fonts. The same drawing and fonts give the same bytes.
std::string to_pdf(const Drawing& drawing);

/// The drawing as pixels on white, so many a point; transparent: without the white.
Image to_image(const Drawing& drawing, double pixels_per_point = 2, bool transparent = false);

/// Throws InputError unless the name ends in .svg, .pdf or .png.
void check_drawing_file(const std::filesystem::path& path);

/// Writes the drawing in the format that the name's extension tells, whole or not at all: .svg, .pdf or .png (two
/// pixels a point). Throws as check_drawing_file(), and InputError where the file cannot be written.
void write_drawing(const std::filesystem::path& path, const Drawing& drawing);

}  // namespace shapegauge
