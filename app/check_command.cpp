// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/check_report.h"
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

struct CheckArguments {
  ShapeFiles files{.output_format = "ply"};
  std::string unit;
  std::string min_wall;
  std::string min_gap;
  std::string min_area = "0";
  ParameterTexts ball;
  std::string format = "text";
  std::string up = "auto";
};

double parse_limit(std::string_view option, const std::string& text, const std::string& unit) {
  if (text.empty()) return 0;
  const double limit = parse_length_option(option, text, unit);
  if (!(limit > 0)) throw InputError(fmt::format("{} is {}; it must be above 0", option, text));
  return limit;
}

CheckOptions options_of(const CheckArguments& arguments) {
  if (arguments.min_wall.empty() && arguments.min_gap.empty())
    throw InputError("--min-wall or --min-gap is required, such as --min-wall 1.2");
  const std::optional<double> min_area = parse_number(arguments.min_area);
  if (!(min_area && *min_area >= 0)) {
    throw InputError(fmt::format("--min-area is {}; it must be a number, 0 or more", quoted_word(arguments.min_area)));
  }
  static constexpr auto parameters = parameters_of(inscribed_ball_table);
  return {.min_wall = parse_limit("--min-wall", arguments.min_wall, arguments.unit),
          .min_gap = parse_limit("--min-gap", arguments.min_gap, arguments.unit),
          .min_area = *min_area,
          .keep_surface = !arguments.files.output.empty(),
          .ball = options_from(inscribed_ball_table, parameter_values(parameters, arguments.ball, "check"))};
}

void print_parts(const CheckArguments& arguments, const std::vector<CheckedPart>& parts) {
  if (arguments.format == "csv") return print_output("{}", to_csv(check_table(parts)));
  if (arguments.format == "json") {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const CheckedPart& part : parts) all.push_back(check_json(part, arguments.unit));
    return print_output("{}\n", json_text(arguments.files.inputs.size() > 1 ? all : all.front(), 2));
  }
  for (const CheckedPart& part : parts) {
    print_output("{}{}", &part == &parts.front() ? "" : "\n", check_text(part, arguments.unit));
  }
}

void remark_on(const PartReport& report, Remarks& remarks) {
  if (!report.closed) {
    remarks.warnings.emplace_back(
        "the mesh is not closed and consistently oriented: where faces point inwards, walls and gaps are exchanged; "
        "repair it ('shapegauge info' lists its defects)");
  }
  const auto is_coarse = [](const ThinRegions& found) { return found.spacing > 1.01 * found.limit; };
  if (is_coarse(report.walls) || is_coarse(report.gaps)) {
    remarks.notes.push_back(fmt::format(
        "the surface is large: faces are sampled every {:.3g}, and narrower thin places within a face may be missed",
        std::max(report.walls.spacing, report.gaps.spacing)));
  }
}

int run(CheckArguments& arguments) {
  set_unit_from_format(arguments.unit, arguments.files.inputs);
  const CheckOptions options = options_of(arguments);
  if (is_standard_stream(arguments.files.output)) {
    throw InputError("the report is written to standard output; --output must be a file");
  }
  SurfaceWriter write;
  if (options.keep_surface) {
    write = surface_writer(output_name(arguments.files), arguments.unit, value_of_word<UpAxis>(arguments.up).value());
  }
  std::vector<std::optional<CheckedPart>> checked(arguments.files.inputs.size());
  const int status = for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
    CheckedPart part{.name = job.input, .report = check_part(shape, options)};
    if (write) write(job.output, part);
    part.report.surface = {};
    remark_on(part.report, remarks);
    checked[job.index] = std::move(part);
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
      "Sharp edges are listed, but are no violation. The exit status is 3 if a shape does not pass.");
  const auto arguments = std::make_shared<CheckArguments>();
  add_shape_inputs(*command, arguments->files);
  add_unit_option(*command, arguments->unit);
  begin_option_group(*command, "Limits");
  command
      ->add_option(
          "--min-wall", arguments->min_wall,
          "Minimum wall thickness, such as 1.2 (file units) or 1.2mm (requires --unit); required without --min-gap")
      ->type_name("LENGTH");
  command
      ->add_option(
          "--min-gap", arguments->min_gap,
          "Minimum gap width, such as 0.5 (file units) or 0.5mm (requires --unit); required without --min-wall")
      ->type_name("LENGTH");
  command
      ->add_option(
          "--min-area", arguments->min_area,
          "Minimum area of listed regions, in squared file units, raised to min(limit²/64, 1 % of the surface) "
          "if less; smaller regions are only counted")
      ->type_name("AREA")
      ->capture_default_str();
  static constexpr auto parameters = parameters_of(inscribed_ball_table);
  for (const Parameter& parameter : parameters) {
    add_parameter_option(*command, parameter, arguments->ball[std::string(parameter.name)]);
  }
  add_shape_outputs(*command, arguments->files, "")
      ->required(false)
      ->description(
          "Output file: .html (page), .png, or .ply, .csv or .npy (thickness or gap width divided by its "
          "limit, per triangle of the subdivided mesh); folder for several inputs");
  add_up_option(*command, arguments->up);
  command->add_option("--format", arguments->format, "Format of the report; json lists the faces of each region")
      ->check(one_of({"text", "json", "csv"}))
      ->capture_default_str();
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
