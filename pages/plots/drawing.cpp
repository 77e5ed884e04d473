// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/plots/drawing.h"

#include <algorithm>
#include <cairo-pdf.h>
#include <cairo.h>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

/// Formats a number with at most two decimals.
std::string coordinate(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string svg_of(const DrawnPath& path) {
  std::string steps;
  for (const auto& [x, y] : path.points) {
    steps += fmt::format("{}{} {}", steps.empty() ? "M" : "L", coordinate(x), coordinate(y));
  }
  std::string style = fmt::format("fill=\"{}\"", path.fill ? css_colour(*path.fill) : "none");
  if (path.stroke) {
    style += fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"", css_colour(*path.stroke),
                         coordinate(path.width));
    if (!path.dashes.empty()) style += fmt::format(" stroke-dasharray=\"{}\"", fmt::join(path.dashes, " "));
  }
  if (path.opacity < 1) style += fmt::format(" opacity=\"{}\"", coordinate(path.opacity));
  return fmt::format("<path d=\"{}{}\" {}/>\n", steps, path.closed ? "Z" : "", style);
}

std::string svg_of(const DrawnText& text) {
  static constexpr std::array<std::string_view, 3> anchors{"start", "middle", "end"};
  const std::string x = coordinate(text.position[0]);
  const std::string y = coordinate(text.position[1]);
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n", x, y,
                     coordinate(text.size), css_colour(text.colour), anchors[static_cast<std::size_t>(text.anchor)],
                     text.bold ? " font-weight=\"bold\"" : "",
                     text.upwards ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "", escaped(text.text));
}

using CairoContext = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using CairoSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(fmt::format("the plot could not be drawn: {}", cairo_status_to_string(status)));
  }
}

void set_colour(cairo_t* context, const Colour& colour, double opacity) {
  cairo_set_source_rgba(context, colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0, opacity);
}

void draw(cairo_t* context, const DrawnPath& path) {
  cairo_new_path(context);
  for (const auto& [x, y] : path.points) cairo_line_to(context, x, y);
  if (path.closed) cairo_close_path(context);
  if (path.fill) {
    set_colour(context, *path.fill, path.opacity);
    cairo_fill_preserve(context);
  }
  if (path.stroke) {
    set_colour(context, *path.stroke, path.opacity);
    cairo_set_line_width(context, path.width);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(context, path.dashes.data(), static_cast<int>(path.dashes.size()), 0);
    cairo_stroke(context);
  }
}

void draw(cairo_t* context, const DrawnText& text) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, text.size);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.text.c_str(), &extents);
  const double part = text.anchor == TextAnchor::start ? 0 : text.anchor == TextAnchor::middle ? 0.5 : 1;
  cairo_save(context);
  cairo_translate(context, text.position[0], text.position[1]);
  if (text.upwards) cairo_rotate(context, -std::numbers::pi / 2);
  cairo_move_to(context, -part * extents.x_advance, 0);
  set_colour(context, text.colour, 1);
  cairo_show_text(context, text.text.c_str());
  cairo_restore(context);
}

void draw(cairo_surface_t* surface, const Drawing& drawing, double scale) {
  const CairoContext context(cairo_create(surface), cairo_destroy);
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context.get(), options);
  cairo_font_options_destroy(options);
  cairo_scale(context.get(), scale, scale);
  for (const auto& element : drawing.elements) {
    std::visit([&](const auto& one) { draw(context.get(), one); }, element);
  }
  require(cairo_status(context.get()));
}

cairo_status_t append_to_string(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void Drawing::line(DrawingPoint from, DrawingPoint to, const Colour& stroke, double width_of_line) {
  path({.points = {from, to}, .stroke = stroke, .width = width_of_line});
}

void Drawing::rectangle(DrawingPoint corner, DrawingPoint size, const Colour& fill) {
  const auto [x, y] = corner;
  path({.points = {{x, y}, {x + size[0], y}, {x + size[0], y + size[1]}, {x, y + size[1]}},
        .closed = true,
        .fill = fill});
}

double estimated_text_width(std::string_view text, double size) {
  double width = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // continuation byte
    const bool narrow = std::string_view(" .,:;'!|()[]ijlftI1").find(c) != std::string_view::npos;
    const bool wide = std::string_view("mwMWOQ@%").find(c) != std::string_view::npos;
    width += narrow ? 0.4 : wide ? 0.9 : 0.63;
  }
  return width * size;
}

std::string to_svg(const Drawing& drawing) {
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#ffffff\"/>\n",
      coordinate(drawing.width), coordinate(drawing.height));
  for (const auto& element : drawing.elements) {
    text += std::visit([](const auto& one) { return svg_of(one); }, element);
  }
  return text + "</svg>\n";
}

std::string to_pdf(const Drawing& drawing) {
  std::string bytes;
  const CairoSurface surface(
      cairo_pdf_surface_create_for_stream(append_to_string, &bytes, drawing.width, drawing.height),
      cairo_surface_destroy);
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);  // the same with every version of Cairo
  // A creation time would make every file different.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  draw(surface.get(), drawing, 1);
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return bytes;
}

Image to_image(const Drawing& drawing, double pixels_per_point, bool transparent) {
  Image image{.width = static_cast<int>(std::lround(drawing.width * pixels_per_point)),
              .height = static_cast<int>(std::lround(drawing.height * pixels_per_point)),
              .pixels = {}};
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height),
                             cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  Drawing whole = drawing;
  if (!transparent) {
    whole.elements.clear();
    whole.rectangle({0, 0}, {drawing.width, drawing.height}, {255, 255, 255});
    whole.elements.insert(whole.elements.end(), drawing.elements.begin(), drawing.elements.end());
  }
  draw(surface.get(), whole, pixels_per_point);
  cairo_surface_flush(surface.get());
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  image.pixels.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      std::uint32_t pixel = 0;  // opacity, red, green, blue; premultiplied, in the machine's order of bytes
      std::copy_n(data + std::ptrdiff_t{row} * stride + std::ptrdiff_t{4} * column, 4,
                  reinterpret_cast<unsigned char*>(&pixel));
      const std::uint32_t opacity = pixel >> 24U;
      for (const unsigned shift : {16U, 8U, 0U}) {
        const std::uint32_t channel = (pixel >> shift) & 0xFFU;
        image.pixels.push_back(static_cast<std::uint8_t>(opacity == 0 ? 0 : (channel * 255 + opacity / 2) / opacity));
      }
      image.pixels.push_back(static_cast<std::uint8_t>(opacity));
    }
  }
  return image;
}

void check_drawing_file(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".svg" || extension == ".pdf" || extension == ".png") return;
  throw InputError(fmt::format("cannot write {}: the name of a plot must end in .svg, .pdf or .png", path.string()));
}

void write_drawing(const std::filesystem::path& path, const Drawing& drawing) {
  check_drawing_file(path);
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".png") return write_png(path, to_image(drawing));
  write_file_atomically(path, extension == ".pdf" ? to_pdf(drawing) : to_svg(drawing));
}

}  // namespace shapegauge
