#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/check/part_check.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

namespace {

using CheckJson = nlohmann::ordered_json;

struct CheckArguments {
  ShapeFiles files;
  std::string unit;
  std::string min_wall;
  std::string min_gap;
  std::string min_area = "0";
  ParameterTexts ball;
  std::string format = "text";
};

/// Report on one of the shapes.
struct CheckedPart {
  std::string name;
  PartReport report;
};

/// Kinds of regions below one of the limits.
struct RegionWords {
  const char* kind;
  const char* edge;  ///< of regions with ThinRegion::is_edge()
  const char* one;   ///< violation
  const char* several;
};
constexpr RegionWords wall_words{"wall", "edge", "thin wall", "thin walls"};
constexpr RegionWords gap_words{"gap", "notch", "narrow gap", "narrow gaps"};

std::string kind_of(const ThinRegion& region, const RegionWords& words) {
  return region.is_edge() ? words.edge : words.kind;
}

double parse_limit(std::string_view option, const std::string& text, const std::string& unit) {
  if (text.empty()) return 0;
  const double limit = parse_length_option(option, text, unit);
  if (!(limit > 0)) throw InputError(fmt::format("{} is {}; it must be above 0", option, text));
  return limit;
}

CheckOptions options_of(const CheckArguments& arguments) {
  if (arguments.min_wall.empty() && arguments.min_gap.empty()) throw InputError("--min-wall or --min-gap is required");
  const std::optional<double> min_area = parse_number(arguments.min_area);
  if (!(min_area && *min_area >= 0)) {
    throw InputError(fmt::format("--min-area is {}; it must be a number, 0 or more", quoted_word(arguments.min_area)));
  }
  static constexpr auto parameters = parameters_of(inscribed_ball_table);
  return {.min_wall = parse_limit("--min-wall", arguments.min_wall, arguments.unit),
          .min_gap = parse_limit("--min-gap", arguments.min_gap, arguments.unit),
          .min_area = *min_area,
          .ball = options_from(inscribed_ball_table, parameter_values(parameters, arguments.ball, "check"))};
}

std::string short_length(double value) { return fmt::format("{:.4g}", value); }

/// Makes the table of the largest regions.
TextTable table_of(const ThinRegions& found, const RegionWords& words, const std::string& unit_name,
                   std::size_t most_rows) {
  const std::string unit = unit_name.empty() ? "" : fmt::format(" ({})", unit_name);
  TextTable table{
      .header = {"kind", "region", unit.empty() ? "area" : fmt::format("area ({}²)", unit_name), "least" + unit,
                 "median" + unit, "short by" + unit, "x" + unit, "y" + unit, "z" + unit, "faces"},
      .rows = {}};
  for (std::size_t i = 0; i < std::min(most_rows, found.regions.size()); ++i) {
    const ThinRegion& region = found.regions[i];
    std::vector<std::string> row{kind_of(region, words), std::to_string(i + 1)};
    for (const double value : {region.area, region.least, region.median, found.limit - region.least,
                               region.position.x(), region.position.y(), region.position.z()}) {
      row.push_back(short_length(value));
    }
    row.push_back(std::to_string(region.faces.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string text_of(const ThinRegions& found, const RegionWords& words, const std::string& unit) {
  constexpr std::size_t most_rows = 20;
  if (found.limit == 0) return "";
  std::string text = fmt::format("{} below {:g}{}: {}\n", words.several, found.limit, unit.empty() ? "" : " " + unit,
                                 found.regions.empty() ? "none" : std::to_string(found.regions.size()));
  if (!found.regions.empty()) text += to_plain_text(table_of(found, words, unit, most_rows));
  if (found.regions.size() > most_rows) {
    text += fmt::format("and {} more; --format csv lists all\n", found.regions.size() - most_rows);
  }
  if (found.small_regions > 0) {
    text += fmt::format("{} smaller than --min-area, of {} in all\n",
                        count_text(static_cast<std::int64_t>(found.small_regions), "region", "regions"),
                        short_length(found.small_area));
  }
  return text;
}

/// Lists violations, or regions that are none: "2 thin walls".
void list_regions(const ThinRegions& found, bool edges, const char* one, const char* several,
                  std::vector<std::string>& list) {
  const auto count = std::ranges::count(found.regions, edges, &ThinRegion::is_edge);
  if (count > 0) list.push_back(count_text(count, one, several));
}

std::string verdict(const PartReport& report) {
  std::vector<std::string> violations;
  list_regions(report.walls, false, wall_words.one, wall_words.several, violations);
  list_regions(report.gaps, false, gap_words.one, gap_words.several, violations);
  if (!violations.empty()) return fmt::format("does not pass: {}", fmt::join(violations, ", "));
  std::vector<std::string> others;
  list_regions(report.walls, true, "sharp edge", "sharp edges", others);
  list_regions(report.gaps, true, "sharp notch", "sharp notches", others);
  return others.empty() ? "passes" : fmt::format("passes; {} below the limit", fmt::join(others, ", "));
}

std::string text_of(const CheckedPart& part, const std::string& unit) {
  return fmt::format("{}\n{}{}closed voids: {}\n{}\n", printable(part.name),
                     text_of(part.report.walls, wall_words, unit), text_of(part.report.gaps, gap_words, unit),
                     part.report.voids, verdict(part.report));
}

CheckJson point_json(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

CheckJson json_of(const ThinRegions& found, const RegionWords& words) {
  if (found.limit == 0) return nullptr;
  CheckJson regions = CheckJson::array();
  for (const ThinRegion& region : found.regions) {
    regions.push_back({{"kind", kind_of(region, words)},
                       {"area", region.area},
                       {"least", region.least},
                       {"median", region.median},
                       {"short_by", found.limit - region.least},
                       {"edge_share", region.edge_share},
                       {"position", point_json(region.position)},
                       {"opposite", point_json(region.opposite)},
                       {"faces", region.faces}});
  }
  return {{"limit", found.limit},           {"passes", found.pass()},
          {"regions", std::move(regions)},  {"small_regions", found.small_regions},
          {"small_area", found.small_area}, {"spacing", found.spacing}};
}

CheckJson json_of(const CheckedPart& part, const std::string& unit) {
  return {{"file", part.name},
          {"unit", unit.empty() ? CheckJson(nullptr) : CheckJson(unit)},
          {"passes", part.report.passes()},
          {"walls", json_of(part.report.walls, wall_words)},
          {"gaps", json_of(part.report.gaps, gap_words)},
          {"voids", part.report.voids},
          {"closed", part.report.closed}};
}

TextTable csv_of(const std::vector<CheckedPart>& parts) {
  TextTable table{.header = {"file", "kind", "region", "area", "least", "median", "short_by", "edge_share", "x", "y",
                             "z", "opposite_x", "opposite_y", "opposite_z", "faces"},
                  .rows = {}};
  const auto add = [&](const CheckedPart& part, const ThinRegions& found, const RegionWords& words) {
    for (std::size_t i = 0; i < found.regions.size(); ++i) {
      const ThinRegion& region = found.regions[i];
      std::vector<std::string> row{part.name, kind_of(region, words), std::to_string(i + 1)};
      for (const double value : {region.area, region.least, region.median, found.limit - region.least,
                                 region.edge_share, region.position.x(), region.position.y(), region.position.z(),
                                 region.opposite.x(), region.opposite.y(), region.opposite.z()}) {
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

void print_parts(const CheckArguments& arguments, const std::vector<CheckedPart>& parts) {
  if (arguments.format == "csv") return print_output("{}", to_csv(csv_of(parts)));
  if (arguments.format == "json") {
    CheckJson all = CheckJson::array();
    for (const CheckedPart& part : parts) all.push_back(json_of(part, arguments.unit));
    return print_output("{}\n", json_text(arguments.files.inputs.size() > 1 ? all : all.front(), 2));
  }
  for (const CheckedPart& part : parts) {
    print_output("{}{}", &part == &parts.front() ? "" : "\n", text_of(part, arguments.unit));
  }
}

void remark_on(const PartReport& report, Remarks& remarks) {
  if (!report.closed) {
    remarks.warnings.emplace_back(
        "the mesh is not closed and consistently oriented: walls and gaps are those of its faces as they are oriented; "
        "'shapegauge info' describes it");
  }
  for (const ThinRegions* const found : {&report.walls, &report.gaps}) {
    if (!(found->spacing > 0.51 * found->limit)) continue;
    remarks.notes.push_back(fmt::format(
        "the surface is large: large faces are sampled every {:.3g}, and narrower thin places of theirs may "
        "be missed",
        found->spacing));
  }
}

int run(const CheckArguments& arguments) {
  const CheckOptions options = options_of(arguments);
  std::vector<std::optional<CheckedPart>> checked(arguments.files.inputs.size());
  const int status = for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
    try {
      checked[job.index] = CheckedPart{job.input, check_part(shape, options)};
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", job.input, error.what()));
    }
    remark_on(checked[job.index]->report, remarks);
  });
  std::vector<CheckedPart> parts;
  for (std::optional<CheckedPart>& part : checked) {
    if (part) parts.push_back(*std::move(part));
  }
  if (parts.empty()) return status;
  print_parts(arguments, parts);
  const bool pass = std::ranges::all_of(parts, [](const CheckedPart& part) { return part.report.passes(); });
  return status == exit_success && !pass ? exit_not_passed : status;
}

}  // namespace

void add_check_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("check", "Check parts for thin walls and narrow gaps");
  command->footer(
      "Example: shapegauge check part.stl --unit mm --min-wall 1.2 --min-gap 0.5\n"
      "         shapegauge check parts/*.stl --unit mm --min-wall 0.05in --format csv > regions.csv\n"
      "Each side of a wall or gap is a region. Sharp edges are listed, but are no violation.\n"
      "Exit status: 0 passes; 3 does not pass; 1 and 2 as for all commands.");
  const auto arguments = std::make_shared<CheckArguments>();
  add_shape_inputs(*command, arguments->files);
  add_unit_option(*command, arguments->unit);
  begin_option_group(*command, "Limits");
  command->add_option("--min-wall", arguments->min_wall, "Minimum thickness of walls, such as 1.2 or 1.2mm")
      ->type_name("LENGTH");
  command->add_option("--min-gap", arguments->min_gap, "Minimum width of gaps")->type_name("LENGTH");
  command
      ->add_option("--min-area", arguments->min_area,
                   "Area, in squared units of the file, below which regions are only counted")
      ->type_name("AREA")
      ->capture_default_str();
  static constexpr auto parameters = parameters_of(inscribed_ball_table);
  for (const Parameter& parameter : parameters) {
    add_parameter_option(*command, parameter, arguments->ball[std::string(parameter.name)]);
  }
  begin_option_group(*command, output_options);
  command->add_option("--format", arguments->format, "Format of the report; json lists the faces of each region")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->capture_default_str();
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
