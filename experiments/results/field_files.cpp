// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/field_files.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/pages/plots/charts.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Describes the colour scale of a file.
std::string scale_text(const ColourScale& scale, const std::string& label) {
  return fmt::format("{}: colours (viridis) from {:.6g} to {:.6g}{}{}", label, scale.low, scale.high,
                     scale.logarithmic ? ", logarithmic" : "",
                     scale.threshold ? fmt::format("; less than {:.6g} is red", *scale.threshold) : "");
}

/// Draws an image over another one, with its upper left corner at a position.
void overlay(Image& image, const Image& front, int left, int top) {
  for (int y = 0; y < std::min(front.height, image.height - top); ++y) {
    for (int x = 0; x < std::min(front.width, image.width - left); ++x) {
      const auto* const from = &front.pixels[4 * static_cast<std::size_t>(y * front.width + x)];
      auto* const to = &image.pixels[4 * static_cast<std::size_t>((top + y) * image.width + left + x)];
      for (int k = 0; k < 3; ++k)
        to[k] = static_cast<std::uint8_t>((from[k] * from[3] + to[k] * (255 - from[3])) / 255);
    }
  }
}

/// Renders the shape, with the legend next to it if there is room.
Image picture_with_legend(const Shape& shape, const Samples& samples, const Eigen::VectorXd& values,
                          const FieldPicture& picture) {
  const ColourScale scale = colour_scale_of({.values = values, .weights = samples.weights}, picture);
  RenderOptions view = picture.upright ? upright_view(shape, picture.render) : picture.render;
  const std::vector<Colour> colours = colours_of(values, scale);
  const double pixels_per_point = std::max(1.0, view.height / 480.0);
  const ColourBar bar{
      .axis = {.label = picture.label, .low = scale.low, .high = scale.high, .logarithmic = scale.logarithmic},
      .height = 0.6 * view.height / pixels_per_point,
      .below = scale.threshold,
      .below_colour = below_threshold};
  const Image legend = to_image(draw_chart(bar), pixels_per_point, true);
  const bool has_room = view.height >= 160 && 3 * legend.width <= view.width;
  const bool has_values = values.array().isFinite().any();
  if (!picture.legend || !has_room || !has_values) return render_shape(shape, colours, samples.site, view);
  const int width = view.width;
  view.width -= legend.width;
  const Image drawn = render_shape(shape, colours, samples.site, view);
  Image image{.width = width, .height = view.height, .pixels = {}};
  image.pixels.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(view.height), 255);
  overlay(image, drawn, 0, 0);
  overlay(image, legend, view.width, (view.height - legend.height) / 2);
  return image;
}

/// Writes a row for each sample: its index, its columns, its weight and, if there are any, its polygon.
void write_csv(const fs::path& path, const Shape& shape, const Samples& samples, const Eigen::MatrixXd& columns,
               std::string_view names) {
  const bool polygons = samples.site == SampleSite::faces && has_polygons(shape);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "index,{},weight{}\n", names, polygons ? ",polygon" : "");
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{}", i, fmt::join(columns.row(i), ","), samples.weights[i]);
    if (polygons) fmt::format_to(std::back_inserter(text), ",{}", polygon_of(shape, i));
    text.push_back('\n');
  }
  write_file_atomically(path, {text.data(), text.size()});
}

void write_values(const fs::path& path, const Shape& /*shape*/, const Samples& /*samples*/,
                  const Eigen::VectorXd& values) {
  write_npy_vector(path, values);
}

void write_normals_csv(const fs::path& path, const Shape& shape, const Samples& samples, const Points& normals) {
  write_csv(path, shape, samples, normals, "nx,ny,nz");
}

void write_normals_npy(const fs::path& path, const Shape& /*shape*/, const Samples& /*samples*/,
                       const Points& normals) {
  write_npy(path, normals);
}

void write_normals_ply(const fs::path& path, const Shape& shape, const Samples& samples, const Points& normals) {
  write_ply(path, shape, samples.site, normals);
}

void write_normals_xyz(const fs::path& path, const Shape& /*shape*/, const Samples& samples, const Points& normals) {
  fmt::memory_buffer text;
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}\n", samples.points(i, 0), samples.points(i, 1),
                   samples.points(i, 2), normals(i, 0), normals(i, 1), normals(i, 2));
  }
  write_file_atomically(path, {text.data(), text.size()});
}

}  // namespace

ColourScale colour_scale_of(const ScalarField& field, const FieldPicture& picture) {
  const Interval range = picture.range ? *picture.range : central_range(field).value_or(Interval{});
  ColourScale scale{
      .low = range.low, .high = range.high, .logarithmic = picture.logarithmic, .threshold = picture.threshold};
  if (!scale.logarithmic || scale.low > 0) return scale;
  scale.low = std::numeric_limits<double>::infinity();
  for (const double value : field.values) {
    if (value > 0) scale.low = std::min(scale.low, value);
  }
  scale.logarithmic = scale.low < scale.high;
  if (!scale.logarithmic) scale.low = range.low;
  return scale;
}

FieldFileWriter field_file_writer(const fs::path& path, const FieldPicture& picture) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".csv") {
    return
        [name = picture.value_name](const fs::path& file, const Shape& shape, const Samples& samples,
                                    const Eigen::VectorXd& values) { write_csv(file, shape, samples, values, name); };
  }
  if (extension == ".npy") return write_values;
  if (extension == ".ply") {
    return [picture](const fs::path& file, const Shape& shape, const Samples& samples, const Eigen::VectorXd& values) {
      const ColourScale scale = colour_scale_of({.values = values, .weights = samples.weights}, picture);
      write_ply(file, shape, samples.site, values, colours_of(values, scale), picture.value_name,
                scale_text(scale, picture.label));
    };
  }
  if (extension == ".png") {
    return [picture](const fs::path& file, const Shape& shape, const Samples& samples, const Eigen::VectorXd& values) {
      write_png(file, picture_with_legend(shape, samples, values, picture));
    };
  }
  throw InputError(fmt::format("cannot write {}: the name must end in .csv, .npy, .ply or .png", path.string()));
}

NormalFileWriter normal_file_writer(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".csv") return write_normals_csv;
  if (extension == ".npy") return write_normals_npy;
  if (extension == ".ply") return write_normals_ply;
  if (extension == ".xyz") return write_normals_xyz;
  throw InputError(fmt::format("cannot write {}: the name must end in .csv, .npy, .ply or .xyz", path.string()));
}

}  // namespace shapegauge
