// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/shape_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/render/splats.h"
#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/packed_numbers.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

constexpr int digits = 7;  ///< of numbers that are not packed

/// Used vertices in the order of first use.
struct VertexOrder {
  std::vector<std::int32_t> vertices;
  std::string corners;  ///< of the triangles, packed
};

/// Encodes each corner as the number of vertices between it and the next unused one, 7 bits a byte, least first.
/// Neighbouring triangles share vertices; most corners therefore take one byte.
VertexOrder order_of_use(const Shape& mesh) {
  VertexOrder order;
  std::vector<std::int32_t> position(static_cast<std::size_t>(mesh.vertices.rows()), -1);
  std::string bytes;
  for (const std::int32_t vertex : mesh.triangles.reshaped<Eigen::RowMajor>()) {
    std::int32_t& at = position[static_cast<std::size_t>(vertex)];
    const auto unused = static_cast<std::int32_t>(order.vertices.size());
    if (at < 0) {
      at = unused;
      order.vertices.push_back(vertex);
    }
    auto back = static_cast<std::uint32_t>(unused - at);
    for (; back > 127; back >>= 7) bytes.push_back(static_cast<char>(128 | (back & 127)));
    bytes.push_back(static_cast<char>(back));
  }
  order.corners = base64(bytes);
  return order;
}

Json packed_points(const Shape& shape, const std::vector<std::int32_t>& vertices) {
  const Eigen::AlignedBox3d box = bounding_box(shape);
  const double step = box.sizes().maxCoeff() / coordinate_level;
  std::string bytes;
  for (const std::int32_t vertex : vertices) {
    for (int k = 0; k < 3; ++k) append_short(bytes, std::lround((shape.vertices(vertex, k) - box.min()[k]) / step));
  }
  return {{"step", rounded_to_digits(step, digits)}, {"values", base64(bytes)}};
}

std::string packed_directions(const Points& directions, const std::vector<std::int32_t>& samples) {
  std::string bytes;
  for (const std::int32_t sample : samples) {
    for (int k = 0; k < 3; ++k)
      bytes.push_back(static_cast<char>(std::lround(direction_levels * directions(sample, k))));
  }
  return base64(bytes);
}

Json packed_field(const ViewField& field, const std::vector<std::int32_t>& samples) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::int32_t sample : samples) {
    const double value = field.values[sample];
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const Eigen::VectorXd values = field.values(samples);
  Json packed{{"name", field.name},
              {"low", low},
              {"high", high},
              {"from", field.colours.low},
              {"to", field.colours.high},
              {"values", packed_values(values, low, high > low ? high - low : 1)}};
  if (field.set_range) packed["set"] = true;
  if (field.logarithmic) packed["log"] = true;
  if (field.threshold) packed["below"] = *field.threshold;
  if (!field.measured_by.empty()) packed["measured"] = {{"by", field.measured_by}, {"unit", field.unit}};
  return packed;
}

Json packed_parts(const ViewParts& parts, const std::vector<std::int32_t>& samples) {
  std::vector<std::int32_t> labels;
  for (const std::int32_t sample : samples) labels.push_back(parts.labels[static_cast<std::size_t>(sample)]);
  Json colours = Json::array();
  for (const Colour& colour : parts.colours) colours.push_back(css_colour(colour));
  return {{"name", parts.name}, {"values", packed_shorts(labels)}, {"colours", std::move(colours)}};
}

/// Encodes the points of a cloud as the hexagons of splats(): sizes and directions.
Json packed_splats(const Shape& cloud, const std::vector<std::int32_t>& vertices) {
  const Shape mesh = splats(cloud);
  const Eigen::Index corners = mesh.vertices.rows() / cloud.vertices.rows();
  Points normals(cloud.vertices.rows(), 3);
  std::vector<double> radii;
  double largest = std::numeric_limits<double>::min();
  for (Eigen::Index i = 0; i < cloud.vertices.rows(); ++i) {
    const Eigen::RowVector3d first = mesh.vertices.row(corners * i) - cloud.vertices.row(i);
    const Eigen::RowVector3d second = mesh.vertices.row(corners * i + 1) - cloud.vertices.row(i);
    normals.row(i) = first.cross(second).normalized();
    radii.push_back(first.norm());
    largest = std::max(largest, radii.back());
  }
  const double step = largest / coordinate_level;
  std::string bytes;
  for (const std::int32_t vertex : vertices)
    append_short(bytes, std::lround(radii[static_cast<std::size_t>(vertex)] / step));
  return {{"step", rounded_to_digits(step, digits)},
          {"values", base64(bytes)},
          {"directions", packed_directions(normals, vertices)}};
}

Json rounded_vector(const Eigen::Vector3d& vector) {
  return {rounded_to_digits(vector[0], digits), rounded_to_digits(vector[1], digits),
          rounded_to_digits(vector[2], digits)};
}

/// Encodes the regions, with positions relative to the middle of the box.
Json packed_regions(const ShapeView& view) {
  const Eigen::Vector3d middle = bounding_box(view.shape).center();
  Json regions = Json::array();
  for (const ViewRegion& region : view.regions) {
    regions.push_back({{"text", region.text},
                       {"position", rounded_vector(region.position - middle)},
                       {"towards", rounded_vector(region.towards_viewer)},
                       {"size", rounded_to_digits(region.size, digits)}});
  }
  return regions;
}

/// Returns the axes of the initial picture: right, up and towards the viewer.
Json first_axes(const ShapeView& view) {
  const RenderOptions look = upright_view(view.shape, {.up = view.up});
  const Eigen::Vector3d towards = look.towards_viewer.normalized();
  const Eigen::Vector3d right = look.up.cross(towards).normalized();
  const Eigen::Vector3d up = towards.cross(right);
  Json axes = Json::array();
  for (const Eigen::Vector3d& axis : {right, up, towards}) axes.push_back(rounded_vector(axis));
  return axes;
}

std::vector<std::int32_t> counted_up(Eigen::Index count) {
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::int32_t>(i);
  return numbers;
}

}  // namespace

std::optional<Interval> central_range(const ScalarField& field) {
  constexpr double left_out = 0.02;
  std::vector<std::pair<double, double>> known;  // value and weight
  double total = 0;
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    if (!std::isfinite(field.values[i]) || !(field.weights[i] > 0)) continue;
    known.emplace_back(field.values[i], field.weights[i]);
    total += field.weights[i];
  }
  if (known.empty()) return std::nullopt;
  std::ranges::sort(known);
  Interval range{known.front().first, known.back().first};
  double below = 0;
  for (const auto& [value, weight] : known) {
    if (below <= left_out * total) range.low = value;
    if (below <= (1 - left_out) * total) range.high = value;
    below += weight;
  }
  return range;
}

std::string_view measured_by(std::string_view field_type) {
  if (field_type == "offset_sdf" || field_type == "cone_sdf") return "ray";
  if (field_type == "inscribed_ball") return "ball";
  return field_type == "gap" ? field_type : "";
}

Json shape_view_json(const ShapeView& view) {
  const Shape& shape = view.shape;
  const double diagonal = bounding_box_diagonal(shape);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) throw InputError("nothing to show: the shape has no finite extent");
  const bool cloud = is_cloud(shape);
  Json json{{"name", view.name}, {"note", view.note}, {"axes", first_axes(view)}};
  std::vector<std::int32_t> samples;
  if (cloud) {
    samples = counted_up(shape.vertices.rows());
    json["vertices"] = packed_points(shape, samples);
    json["radii"] = packed_splats(shape, samples);
  } else {
    VertexOrder order = order_of_use(shape);
    json["vertices"] = packed_points(shape, order.vertices);
    json["triangles"] = {{"count", shape.triangles.rows()}, {"corners", std::move(order.corners)}};
    const bool faces = view.site == SampleSite::faces;
    json["site"] = faces ? "faces" : "vertices";
    samples = faces ? counted_up(shape.triangles.rows()) : std::move(order.vertices);
  }
  json["fields"] = Json::array();
  for (const ViewField& field : view.fields) {
    if (field.values(samples).array().isFinite().any()) json["fields"].push_back(packed_field(field, samples));
  }
  for (const ViewParts& parts : view.parts) json["parts"].push_back(packed_parts(parts, samples));
  if (!view.regions.empty()) json["regions"] = packed_regions(view);
  if (view.normals.rows() > 0) json["directions"] = packed_directions(view.normals, samples);
  return json;
}

std::string shape_view_picture(const ShapeView& view, int pixels) {
  const bool faces = !is_cloud(view.shape) && view.site == SampleSite::faces;
  const Eigen::Index sample_count = faces ? view.shape.triangles.rows() : view.shape.vertices.rows();
  std::vector<Colour> colours(static_cast<std::size_t>(sample_count), plain_colour);
  if (!view.fields.empty()) {
    const ViewField& field = view.fields.front();
    colours = colours_of(field.values, ColourScale{.low = field.colours.low,
                                                   .high = field.colours.high,
                                                   .logarithmic = field.logarithmic,
                                                   .threshold = field.threshold});
  }
  const RenderOptions look = upright_view(
      view.shape, {.width = pixels, .height = pixels, .up = view.up, .rays_per_side = 2, .transparent = true});
  return encode_png(render_shape(view.shape, colours, faces ? SampleSite::faces : SampleSite::vertices, look));
}

std::string view_page(const ViewPage& page) {
  constexpr int picture_pixels = 480;
  std::vector<Json> shapes(page.shapes.size());
  parallel_for(std::size_t{0}, page.shapes.size(), [&](std::size_t i) {
    shapes[i] = shape_view_json(page.shapes[i]);
    shapes[i]["picture"] = base64(shape_view_picture(page.shapes[i], picture_pixels));
  });
  return scripted_page({.title = page.title,
                        .kind = "view",
                        .main = page_files::view_page(),
                        .styles = {page_files::view_style()},
                        .libraries = {page_files::chart_library(), page_files::shape_library()},
                        .data = {{"version", version()},
                                 {"title", page.title},
                                 {"missing", page.missing},
                                 {"warnings", page.warnings},
                                 {"unit", page.unit},
                                 {"shapes", std::move(shapes)}},
                        .script = page_files::view_script()});
}

}  // namespace shapegauge
