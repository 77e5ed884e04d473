// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check_report.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/pages/coarse_view.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using CheckJson = nlohmann::ordered_json;

/// Kinds of regions below one of the limits.
struct RegionWords {
  const char* kind;
  const char* edge;  ///< of regions with ThinRegion::is_edge
  const char* one;   ///< violation
  const char* several;
  const char* one_edge;
  const char* several_edges;
};
constexpr RegionWords wall_words{"wall", "edge", "thin wall", "thin walls", "sharp edge", "sharp edges"};
constexpr RegionWords gap_words{"gap", "notch", "narrow gap", "narrow gaps", "sharp notch", "sharp notches"};

std::string kind_of(const ThinRegion& region, const RegionWords& words) {
  return region.is_edge ? words.edge : words.kind;
}

std::string short_length(double value) { return fmt::format("{:.4g}", value); }

/// Makes the table of the largest regions.
TextTable table_of(const ThinRegions& found, const RegionWords& words, const std::string& unit_name,
                   std::size_t row_limit) {
  const std::string unit = unit_name.empty() ? "" : fmt::format(" ({})", unit_name);
  TextTable table{
      .header = {"kind", "region", unit.empty() ? "area" : fmt::format("area ({}²)", unit_name), "minimum" + unit,
                 "median" + unit, "short by" + unit, "x" + unit, "y" + unit, "z" + unit, "faces"},
      .rows = {}};
  for (std::size_t i = 0; i < std::min(row_limit, found.regions.size()); ++i) {
    const ThinRegion& region = found.regions[i];
    std::vector<std::string> row{kind_of(region, words), std::to_string(i + 1)};
    for (const double value : {region.area, region.minimum, region.median, found.limit - region.minimum,
                               region.position.x(), region.position.y(), region.position.z()}) {
      row.push_back(short_length(value));
    }
    row.push_back(std::to_string(region.faces.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Adds the number of violations, or of edges, to the list if there are any: "2 thin walls".
void list_regions(const ThinRegions& found, bool edges, const RegionWords& words, std::vector<std::string>& list) {
  const auto count = std::ranges::count(found.regions, edges, &ThinRegion::is_edge);
  if (count == 0) return;
  list.push_back(edges ? count_text(count, words.one_edge, words.several_edges)
                       : count_text(count, words.one, words.several));
}

std::string text_of(const ThinRegions& found, const RegionWords& words, const std::string& unit) {
  constexpr std::size_t row_limit = 20;
  if (found.limit == 0) return "";
  std::vector<std::string> counts;
  for (const bool edges : {false, true}) list_regions(found, edges, words, counts);
  std::string text = fmt::format("{}s below {:g}{}: {}\n", words.kind, found.limit, unit.empty() ? "" : " " + unit,
                                 counts.empty() ? "none" : fmt::format("{}", fmt::join(counts, ", ")));
  if (!found.regions.empty()) text += to_plain_text(table_of(found, words, unit, row_limit));
  if (found.regions.size() > row_limit) {
    text += fmt::format("and {} more; --format csv lists all\n", found.regions.size() - row_limit);
  }
  if (found.small_regions > 0) {
    text += fmt::format("{} smaller than --min-area, of {} in all\n",
                        count_text(static_cast<std::int64_t>(found.small_regions), "region", "regions"),
                        short_length(found.small_area));
  }
  return text;
}

std::string verdict(const PartReport& report) {
  std::vector<std::string> violations;
  list_regions(report.walls, false, wall_words, violations);
  list_regions(report.gaps, false, gap_words, violations);
  if (!violations.empty()) return fmt::format("does not pass: {}", fmt::join(violations, ", "));
  std::vector<std::string> others;
  list_regions(report.walls, true, wall_words, others);
  list_regions(report.gaps, true, gap_words, others);
  return others.empty() ? "passes" : fmt::format("passes; {} below the limit", fmt::join(others, ", "));
}

CheckJson point_json(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

CheckJson json_of(const ThinRegions& found, const RegionWords& words) {
  if (found.limit == 0) return nullptr;
  CheckJson regions = CheckJson::array();
  for (const ThinRegion& region : found.regions) {
    regions.push_back({{"kind", kind_of(region, words)},
                       {"area", region.area},
                       {"minimum", region.minimum},
                       {"median", region.median},
                       {"short_by", found.limit - region.minimum},
                       {"position", point_json(region.position)},
                       {"opposite", point_json(region.opposite)},
                       {"faces", region.faces}});
  }
  return {{"limit", found.limit},           {"passes", found.pass()},
          {"regions", std::move(regions)},  {"small_regions", found.small_regions},
          {"small_area", found.small_area}, {"spacing", found.spacing}};
}

constexpr const char* fraction_words = "fraction of the limit";

/// Returns the entries of a page's list of regions. Walls are seen from outside, gaps from the side.
std::vector<ViewRegion> view_regions(const PartReport& report, const std::string& unit) {
  const Eigen::Vector3d middle = bounding_box(report.surface.mesh).center();
  std::vector<ViewRegion> regions;
  const auto add = [&](const ThinRegions& found, const RegionWords& words, bool across) {
    for (const ThinRegion& region : found.regions) {
      Eigen::Vector3d direction = (region.position - region.opposite).normalized();
      if (across) {
        const Eigen::Vector3d outwards = region.position - middle;
        direction = outwards - outwards.dot(direction) * direction + 1e-3 * found.limit * direction;
      }
      regions.push_back(
          {.text = fmt::format("{}: minimum {}{}, area {}", kind_of(region, words), short_length(region.minimum),
                               unit.empty() ? "" : " " + unit, short_length(region.area)),
           .position = region.position,
           .towards_viewer = direction.normalized(),
           .size = std::max(std::sqrt(region.area), 2 * found.limit)});
    }
  };
  add(report.walls, wall_words, false);
  add(report.gaps, gap_words, true);
  return regions;
}

void write_page(const fs::path& path, const CheckedPart& part, const std::string& unit, UpAxis up) {
  constexpr Eigen::Index max_faces = 200'000;
  const std::string name = fs::path(part.name).filename().string();
  ShapeView view{.name = name, .note = verdict(part.report), .shape = part.report.surface.mesh};
  view.fields = {
      {.name = fraction_words, .values = part.report.surface.fractions, .colours = {0, 1}, .set_range = true}};
  const bool walls = part.report.walls.limit > 0;
  if (walls != (part.report.gaps.limit > 0)) {  // of both, fractions do not say which
    view.fields.front().measured_by = walls ? "ball" : "gap";
    view.fields.front().unit = walls ? part.report.walls.limit : part.report.gaps.limit;
  }
  view.up = up_direction(up, part.name);
  view.regions = view_regions(part.report, unit);
  const Samples samples = sample_shape(view.shape, view.site);
  ViewPage page{.title = name, .shapes = {}, .missing = {}};
  page.shapes.push_back(coarse_view(std::move(view), samples, max_faces));
  write_file_atomically(path, view_page(page));
}

}  // namespace

std::string check_text(const CheckedPart& part, const std::string& unit) {
  return fmt::format("{}\n{}{}closed voids: {}\n{}\n", printable(part.name),
                     text_of(part.report.walls, wall_words, unit), text_of(part.report.gaps, gap_words, unit),
                     part.report.voids, verdict(part.report));
}

nlohmann::ordered_json check_json(const CheckedPart& part, const std::string& unit) {
  return {{"file", part.name},
          {"unit", unit.empty() ? CheckJson(nullptr) : CheckJson(unit)},
          {"passes", part.report.passes()},
          {"walls", json_of(part.report.walls, wall_words)},
          {"gaps", json_of(part.report.gaps, gap_words)},
          {"voids", part.report.voids},
          {"closed", part.report.closed}};
}

TextTable check_table(std::span<const CheckedPart> parts) {
  TextTable table{.header = {"file", "kind", "region", "area", "minimum", "median", "short_by", "x", "y", "z",
                             "opposite_x", "opposite_y", "opposite_z", "faces"},
                  .rows = {}};
  const auto add = [&](const CheckedPart& part, const ThinRegions& found, const RegionWords& words) {
    for (std::size_t i = 0; i < found.regions.size(); ++i) {
      const ThinRegion& region = found.regions[i];
      std::vector<std::string> row{part.name, kind_of(region, words), std::to_string(i + 1)};
      for (const double value :
           {region.area, region.minimum, region.median, found.limit - region.minimum, region.position.x(),
            region.position.y(), region.position.z(), region.opposite.x(), region.opposite.y(), region.opposite.z()}) {
        row.push_back(fmt::format("{}", value));
      }
      row.push_back(std::to_string(region.faces.size()));
      table.rows.push_back(std::move(row));
    }
  };
  for (const CheckedPart& part : parts) {
    add(part, part.report.walls, wall_words);
    add(part, part.report.gaps, gap_words);
  }
  return table;
}

SurfaceWriter surface_writer(const fs::path& name, const std::string& unit, UpAxis up) {
  if (is_page(name)) {
    return [unit, up](const fs::path& path, const CheckedPart& part) { write_page(path, part, unit, up); };
  }
  (void)field_file_writer(name);  // reports a wrong extension
  return [up](const fs::path& path, const CheckedPart& part) {
    const CheckedSurface& surface = part.report.surface;
    const FieldPicture picture{.render = {.up = up_direction(up, part.name)},
                               .label = fraction_words,
                               .value_name = "fraction",
                               .range = Interval{0, 1}};
    field_file_writer(path, picture)(path, surface.mesh, sample_shape(surface.mesh, SampleSite::faces),
                                     surface.fractions);
  };
}

}  // namespace shapegauge
