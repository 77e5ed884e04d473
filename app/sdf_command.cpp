// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
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
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/experiments/results/thickness_summary.h"
#include "shapegauge/experiments/signatures/shape_reports.h"
#include "shapegauge/pages/plots/charts.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Returns the fields of thickness.
std::vector<std::reference_wrapper<const FieldType>> methods() {
  std::vector<std::reference_wrapper<const FieldType>> types = field_types().entries();
  std::erase_if(types, [](const FieldType& type) { return !type.is_thickness; });
  return types;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const FieldType& type : methods()) names.push_back(type.name);
  return names;
}

/// Describes the methods for --help: "offset_sdf: ...; cone_sdf: ...".
std::string descriptions_of_methods() {
  std::vector<std::string> texts;
  for (const FieldType& type : methods()) {
    std::string text = without_full_stop(type.description);
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    texts.push_back(fmt::format("{}: {}", type.name, text));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

struct SdfArguments {
  ShapeFiles files{.output_format = "csv"};
  std::string method = "offset_sdf";
  std::string site{word_of(SamplePlan{}.site)};
  OffsetArguments offset{.offset = fmt::format("{:g}%", 100 * OffsetSdfOptions{}.offset)};
  ParameterTexts settings;  ///< of the method, without the offset
  CleaningArguments cleaning;
  fs::path timings;
  std::string picture_size = "640x480";
  std::string view;  ///< empty: upright_view()
  std::string up = "auto";
  ColourArguments colours;
  bool no_legend = false;
  bool summary = false;
  std::string format = "table";
  fs::path plot;
};

/// Parses the numbers between separators; empty if a word is not a number.
std::vector<double> numbers_in(const std::string& text, char separator) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, separator);) {
    const std::optional<double> number = parse_number(word);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::string name_of_values(const SdfArguments& arguments) {
  return arguments.method == "inscribed_ball" ? "inscribed ball" : "SDF";
}

FieldPicture picture_of(const SdfArguments& arguments) {
  FieldPicture picture;
  const ColourChoice colours = parse_colours(arguments.colours, arguments.offset.unit);
  const std::string& unit = arguments.offset.unit;
  picture.label = name_of_values(arguments) + (unit.empty() ? "" : fmt::format(" ({})", unit));
  picture.value_name = arguments.method.ends_with("_sdf") ? "sdf" : arguments.method;
  picture.range = colours.range;
  picture.logarithmic = colours.logarithmic;
  picture.threshold = colours.threshold;
  picture.legend = !arguments.no_legend;
  const std::vector<double> size = numbers_in(arguments.picture_size, 'x');
  constexpr double largest = 16384;
  if (size.size() != 2 || !(size[0] >= 1 && size[0] <= largest && size[1] >= 1 && size[1] <= largest)) {
    throw InputError(
        fmt::format("--picture-size is {}; it must be width and height in pixels, from 1 to {}, such as 1280x960",
                    quoted_word(arguments.picture_size), largest));
  }
  picture.render.width = static_cast<int>(size[0]);
  picture.render.height = static_cast<int>(size[1]);
  picture.upright = arguments.view.empty();
  if (picture.upright) return picture;
  const std::vector<double> direction = numbers_in(arguments.view, ',');
  if (direction.size() != 3) {
    throw InputError(fmt::format("--view is {}; it must be the direction to the viewer, such as 0,0,1",
                                 quoted_word(arguments.view)));
  }
  picture.render.towards_viewer = Eigen::Vector3d(direction[0], direction[1], direction[2]);
  return picture;
}

/// Returns the picture with the vertical direction of a file.
FieldPicture upright_picture(FieldPicture picture, const SdfArguments& arguments, const std::string& file) {
  const Eigen::Vector3d& towards = picture.render.towards_viewer;
  Eigen::Vector3d& up = picture.render.up;
  up = up_direction(value_of_word<UpAxis>(arguments.up).value(), file);
  // In a view from straight above or below, the back of the shape is at the top.
  if (!picture.upright && towards.cross(up).norm() <= 1e-6 * towards.norm()) up = -front_of(up);
  return picture;
}

bool is_offset_sdf(const SdfArguments& arguments) { return arguments.method == "offset_sdf"; }

/// Makes the requested field. `offset` is that of the offset SDF; automatic if absent.
Field requested_field(const SdfArguments& arguments, std::optional<double> offset) {
  FieldSettings settings = field_settings(arguments.method);
  settings.samples.site = value_of_word<SampleSite>(arguments.site).value();
  settings.values = parameter_values(settings.values.parameters(), arguments.settings, "--method " + arguments.method);
  if (is_offset_sdf(arguments))
    settings.values.set("offset", offset ? ParameterValue(*offset) : ParameterValue("auto"));
  return make_field(std::move(settings));
}

/// Values computed for a shape.
struct Computed {
  std::optional<ChosenOffset> chosen;  ///< for the offset method only
  Samples samples;
  FieldValues field;
};

Computed compute(const SdfArguments& arguments, const RequestedOffset& offset, const Shape& shape) {
  Computed computed;
  if (is_offset_sdf(arguments)) computed.chosen = choose_offset(offset.fraction_of(shape), shape);
  const Field field =
      requested_field(arguments, computed.chosen ? std::optional(computed.chosen->offset) : std::nullopt);
  computed.samples = take_samples(shape, field.settings.samples);
  FieldSource source(shape);
  computed.field = field.compute(source, computed.samples, true);
  return computed;
}

void write_timings(const fs::path& path, const Shape& shape, double read_seconds, const Computed& computed) {
  nlohmann::ordered_json timings{{"read_seconds", read_seconds},
                                 {"build_seconds", computed.field.build_seconds},
                                 {"query_seconds", computed.field.query_seconds},
                                 {"samples", computed.field.outcomes}};
  if (computed.chosen) timings["offset"] = to_json(*computed.chosen);
  timings["shape"] = diagnostics_json(diagnose(shape));
  write_file_atomically(path, timings.dump(2) + "\n");
}

/// Adds an option for each parameter of the methods.
void add_settings(CLI::App& command, SdfArguments& arguments) {
  for (const FieldType& method : methods()) {
    for (const Parameter& parameter : method.parameters) {
      if (parameter.name == "offset") continue;
      add_parameter_option(command, parameter, arguments.settings[std::string(parameter.name)], "",
                           fmt::format("{}: {}", method.name, parameter_help_text(parameter)));
    }
  }
}

/// Adds --output, --summary, --format and --plot.
void add_outputs(CLI::App& command, SdfArguments& arguments) {
  add_shape_outputs(command, arguments.files, ".csv (index, value, area weight), .npy, .ply (coloured shape) or .png")
      ->required(false);
  command.add_flag("--summary", arguments.summary,
                   "Print minimum, percentiles, maximum, mean and the area thinner than --below; implied without "
                   "-o and --plot");
  add_format_option(command, arguments.format, "Format of the printed result");
  command.add_option("--plot", arguments.plot, "File for a thickness histogram: .svg, .pdf or .png");
}

/// Adds the options of colours, legend, size and view.
void add_picture_options(CLI::App& command, SdfArguments& arguments) {
  add_colour_options(command, arguments.colours);
  command.add_flag("--no-legend", arguments.no_legend, "Omit the legend in .png pictures");
  command.add_option("--picture-size", arguments.picture_size, "Size of .png pictures, in pixels")
      ->capture_default_str();
  command
      .add_option(
          "--view", arguments.view,
          "Direction from shape to viewer in .png pictures, such as 0,0,1 (default: facing the broad side, slightly "
          "from above)")
      ->type_name("X,Y,Z");
  add_up_option(command, arguments.up);
}

/// Data of a measured shape for --summary and --plot.
struct Measured {
  std::string name;
  ScalarField field;
};

void print_summaries(const SdfArguments& arguments, const std::vector<Measured>& shapes,
                     std::optional<double> threshold) {
  const SummaryWords words{.unit = arguments.offset.unit, .threshold = threshold};
  std::vector<NamedSummary> summaries;
  for (const Measured& shape : shapes) {
    summaries.push_back({.name = shape.name, .summary = summarise(shape.field, threshold)});
  }
  if (arguments.format == "json") {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const NamedSummary& summary : summaries) all.push_back(summary_json(summary, words));
    print_output("{}\n", json_text(arguments.files.inputs.size() > 1 ? all : all.front(), 2));
    return;
  }
  const auto format = value_of_word<TableFormat>(arguments.format).value();
  print_output("{}", table_text(thickness_summary_table(summaries, words), format));
}

/// Draws the distribution of values by area, with common bins for all shapes.
Drawing histogram_plot(const SdfArguments& arguments, const std::vector<Measured>& shapes,
                       const FieldPicture& picture) {
  constexpr std::size_t bins = 48;
  Interval range{std::numeric_limits<double>::infinity(), 0};
  for (const Measured& shape : shapes) {
    const Interval values = central_range(shape.field).value_or(Interval{});
    range = {std::min(range.low, values.low), std::max(range.high, values.high)};
  }
  range.low = 0;
  if (picture.range) range = *picture.range;
  HistogramChart chart{.title = shapes.size() == 1 ? fs::path(shapes[0].name).filename().string() : "",
                       .x = {.label = picture.label, .low = range.low, .high = range.high},
                       .histograms = {}};
  for (const Measured& shape : shapes) {
    const double total = shape.field.weights.sum();
    std::vector<double> shares(bins, 0);
    for (Eigen::Index i = 0; i < shape.field.values.size(); ++i) {
      const double part = chart.x.part(shape.field.values[i]) * bins;
      if (part >= 0 && part <= bins) {
        shares[std::min(bins - 1, static_cast<std::size_t>(part))] += shape.field.weights[i] / total;
      }
    }
    chart.histograms.push_back({.name = fs::path(shape.name).filename().string(), .shares = std::move(shares)});
  }
  if (!picture.threshold) return draw_chart(chart);
  chart.mark = picture.threshold;
  chart.mark_label =
      fmt::format("{:g}{}", *picture.threshold, arguments.offset.unit.empty() ? "" : " " + arguments.offset.unit);
  return draw_chart(chart);
}

void check_outputs(SdfArguments& arguments) {
  if (arguments.files.output.empty() && arguments.plot.empty()) arguments.summary = true;
  if (!arguments.timings.empty() && arguments.files.inputs.size() > 1) {
    throw InputError("--timings requires a single shape");
  }
  if (arguments.summary && is_standard_stream(arguments.files.output)) {
    throw InputError("--summary and --output would both be written to standard output; name a file for --output");
  }
  if (!arguments.plot.empty()) check_drawing_file(arguments.plot);
  arguments.files.others = {{.path = arguments.timings, .what = "--timings", .extensions = {".json"}},
                            {.path = arguments.plot, .what = "--plot"}};
}

int run(SdfArguments& arguments) {
  check_outputs(arguments);
  arguments.offset.unit_of_files = set_unit_from_format(arguments.offset.unit, arguments.files.inputs);
  const FieldPicture picture = picture_of(arguments);
  const RequestedOffset offset = is_offset_sdf(arguments) ? parse_offset(arguments.offset) : RequestedOffset{};
  requested_field(arguments, offset.fraction);  // reports wrong settings before any file is read
  const fs::path name = arguments.files.output.empty() ? fs::path() : output_name(arguments.files);
  if (!name.empty()) (void)field_file_writer(name);  // reports a wrong extension
  std::vector<std::optional<Measured>> measured(arguments.files.inputs.size());
  const int status = for_each_shape(arguments.files, [&](const Shape& input, const ShapeJob& job, Remarks& remarks) {
    const Shape shape = cleaned(input, arguments.cleaning, is_offset_sdf(arguments) && offset.is_automatic(), remarks);
    Computed computed = compute(arguments, offset, shape);
    if (!name.empty()) {
      const FieldFileWriter write = field_file_writer(name, upright_picture(picture, arguments, job.input));
      write(job.output, shape, computed.samples, computed.field.values);
      remark_on_polygons(shape, computed.samples.site, remarks);
    }
    if (!arguments.timings.empty()) write_timings(arguments.timings, shape, job.read_seconds, computed);
    if (computed.chosen) remark_on(*computed.chosen, remarks);
    remark_on_cavities(shape, is_offset_sdf(arguments), remarks);
    remark_on(computed.field.outcomes, remarks);
    if (auto warning = weights_warning(computed.samples)) remarks.warnings.push_back(*std::move(warning));
    if (!arguments.summary && arguments.plot.empty()) return;
    measured[job.index] = {
        .name = job.input,
        .field = {.values = std::move(computed.field.values), .weights = std::move(computed.samples.weights)}};
  });
  std::vector<Measured> shapes;
  for (std::optional<Measured>& shape : measured) {
    if (shape) shapes.push_back(std::move(*shape));
  }
  if (shapes.empty()) return status;
  if (arguments.summary) print_summaries(arguments, shapes, picture.threshold);
  if (!arguments.plot.empty()) write_drawing(arguments.plot, histogram_plot(arguments, shapes, picture));
  return status;
}

}  // namespace

void add_sdf_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("sdf", "Compute the thickness of shapes by the shape diameter function or inscribed balls");
  command->footer(
      "Example: shapegauge sdf bunny.off\n"
      "         shapegauge sdf bunny.off --offset 3% -o bunny.ply\n"
      "         shapegauge sdf bracket.stl --method inscribed_ball --unit mm --summary --below 2mm\n"
      "Values are in file units.");
  const auto arguments = std::make_shared<SdfArguments>();
  add_shape_inputs(*command, arguments->files);
  begin_option_group(*command, "Method");
  command->add_option("--method", arguments->method, descriptions_of_methods())
      ->check(one_of(method_names()))
      ->capture_default_str()
      ->transform([](const std::string& name) { return name == "ball" ? "inscribed_ball" : name; });  // short
  add_outputs(*command, *arguments);
  begin_option_group(*command, "Method");
  add_site_option(*command, arguments->site);
  CLI::Option* const offset = add_offset_option(*command, arguments->offset);
  add_settings(*command, *arguments);
  add_cleaning_options(*command, arguments->cleaning);
  begin_option_group(*command, "Colours and pictures");
  add_picture_options(*command, *arguments);
  begin_option_group(*command, output_options);
  command->add_option(
      "--timings", arguments->timings,
      "JSON file for run times, counts of missing values and the report of 'shapegauge info'; one shape only");
  command->callback([arguments, &status, offset] {
    if (!is_offset_sdf(*arguments) && offset->count() > 0) {
      throw InputError("--offset does not apply to --method " + arguments->method);
    }
    status = run(*arguments);
  });
}

}  // namespace shapegauge
