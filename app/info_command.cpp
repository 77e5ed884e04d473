// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/preparation/cavities.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/signatures/shape_reports.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

struct InfoArguments {
  ShapeFiles files;
  std::string format = "text";
};

/// Returns the number of handles of a closed mesh, summed over its components: components - (V - E + F) / 2. A vertex
/// counts once for each fan of triangles about it. Components that touch in a point are therefore separate.
long genus(const Shape& shape) {
  const std::vector<HalfEdge> uses = surface_half_edges(shape, welding_of(shape));
  std::vector<std::size_t> leader(static_cast<std::size_t>(3 * shape.triangles.rows()));
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  const auto corner_of = [](const HalfEdge& use, bool low) {
    const int corner = low == use.forward ? use.corner : (use.corner + 1) % 3;
    return 3 * static_cast<std::size_t>(use.triangle) + static_cast<std::size_t>(corner);
  };
  long edges = 0;
  std::set<std::int32_t> faces;
  for_each_edge(std::span(uses), [&](std::span<const HalfEdge> sides) {
    ++edges;
    for (const bool low : {true, false}) leader[find(corner_of(sides[0], low))] = find(corner_of(sides[1], low));
    for (const HalfEdge& side : sides) faces.insert(side.triangle);
  });
  std::set<std::size_t> fans;
  for (const std::int32_t face : faces) {
    for (std::size_t corner = 0; corner < 3; ++corner) fans.insert(find(3 * static_cast<std::size_t>(face) + corner));
  }
  // Triangles belong to one component if a triangle links their fans.
  std::vector<std::size_t> part = leader;
  const auto find_part = [&](std::size_t i) {
    while (part[i] != i) i = part[i] = part[part[i]];
    return i;
  };
  for (const std::int32_t face : faces) {
    for (std::size_t corner = 1; corner < 3; ++corner) {
      part[find_part(3 * static_cast<std::size_t>(face) + corner)] = find_part(3 * static_cast<std::size_t>(face));
    }
  }
  std::set<std::size_t> parts;
  for (const std::size_t fan : fans) parts.insert(find_part(fan));
  const long characteristic = std::ssize(fans) - edges + std::ssize(faces);
  return std::ssize(parts) - characteristic / 2;
}

/// Describes the orientation of the triangles; "none" without triangles. `components` are those of a solid.
std::string winding(const Shape& shape, const ShapeDiagnostics& found, const ClosedComponents& components) {
  if (found.triangles == 0) return "none";
  if (found.inconsistent_edges > 0 || found.non_manifold_edges > 0) return "inconsistent";
  const double volume = found.closed ? signed_volume(shape) : std::numeric_limits<double>::quiet_NaN();
  if (std::isnan(volume)) return "consistent";
  if (components.reversed > 0) return "mixed";
  return volume > 0 ? "outward" : "inward";
}

/// Returns position, volume, genus and winding; null if undefined. Volume and genus need a closed, consistently
/// oriented mesh with two triangles at every edge.
OrderedJson geometry_json(const Shape& shape, const ShapeDiagnostics& found) {
  const Eigen::AlignedBox3d box = bounding_box(shape);
  const bool solid = found.closed && found.non_manifold_edges == 0 && found.inconsistent_edges == 0;
  const ClosedComponents components = solid ? closed_components(shape) : ClosedComponents{};
  OrderedJson json{
      {"bounding_box",
       {{"min", {box.min()[0], box.min()[1], box.min()[2]}}, {"max", {box.max()[0], box.max()[1], box.max()[2]}}}},
      {"volume", nullptr},
      {"genus", nullptr},
      {"winding", winding(shape, found, components)}};
  if (solid) {
    json["volume"] = components.volume;
    json["genus"] = genus(shape);
  }
  return json;
}

OrderedJson info_of(const Shape& shape) {
  const ShapeDiagnostics found = diagnose(shape);
  OrderedJson json = diagnostics_json(found);
  if (has_polygons(shape)) json["polygons"] = polygon_count(shape);
  json.update(geometry_json(shape, found));
  if (is_cloud(shape)) {
    json["normals"] = shape.normals.rows() == 0 ? "none"
                      : found.stray_normals     ? "from the file, not of the surface: ignored"
                                                : "from the file";
  }
  return json;
}

std::string value_text(const OrderedJson& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_null()) return "none";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return "too large to compute";
  constexpr int digits = 6;
  if (value.is_number_float()) return plain_number(value, digits);
  if (!value.is_object()) return value.dump();
  const auto corner = [&](const char* name) {
    std::vector<std::string> numbers;
    for (const double coordinate : value[name]) numbers.push_back(plain_number(coordinate, digits));
    return fmt::format("{}", fmt::join(numbers, " "));
  };
  return corner("min") + " to " + corner("max");
}

std::string text_of(const OrderedJson& info) {
  std::string text;
  for (const auto& [name, value] : info.items()) {
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    text += fmt::format("{:<24}{}\n", words, value_text(value));
  }
  return text;
}

int run(const InfoArguments& arguments) {
  std::vector<OrderedJson> infos(arguments.files.inputs.size());  // null where a shape could not be used
  std::vector<std::string> names(infos.size());
  const int status = for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks&) {
    names[job.index] = job.input;
    infos[job.index] = info_of(shape);
  });
  const bool several = infos.size() > 1;
  OrderedJson all = OrderedJson::array();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (infos[i].is_null()) continue;
    if (arguments.format == "text") {
      print_output("{}{}", several ? fmt::format("{}{}\n", all.empty() ? "" : "\n", printable(names[i])) : "",
                   text_of(infos[i]));
    }
    OrderedJson named{{"file", names[i]}};
    named.update(infos[i]);
    all.push_back(several ? std::move(named) : infos[i]);
  }
  if (arguments.format == "json") print_output("{}\n", json_text(several ? all : all.front(), 2));
  return status;
}

}  // namespace

void add_info_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("info", "Report topology, components and defects of shapes");
  command->footer(
      "Example: shapegauge info bunny.off\nVolume and genus are reported for closed, consistently oriented meshes "
      "only.");
  const auto arguments = std::make_shared<InfoArguments>();
  add_shape_inputs(*command, arguments->files);
  begin_option_group(*command, output_options);
  command->add_option("--format", arguments->format, "Format of the report; lengths and areas in file units")
      ->check(one_of({"text", "json"}))
      ->capture_default_str();
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
