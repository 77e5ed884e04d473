#include <CLI/CLI.hpp>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/experiments/signatures/shape_reports.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> methods{"offset_sdf", "cone_sdf"};

struct SdfArguments {
  ShapeFiles files{.output_format = "csv"};
  std::string method;
  std::string site = "faces";
  std::string offset = "0.05";
  ParameterTexts settings;  ///< of the method, but for the offset
  bool denoise = false;
  fs::path timings;
  std::string picture_size = "640x480";
  std::string view = "0.6,0.45,1";
};

/// The numbers between the separators; none where a word is no number.
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

FieldPicture picture_of(const SdfArguments& arguments) {
  FieldPicture picture;
  const std::vector<double> size = numbers_in(arguments.picture_size, 'x');
  constexpr double largest = 16384;
  if (size.size() != 2 || !(size[0] >= 1 && size[0] <= largest && size[1] >= 1 && size[1] <= largest)) {
    throw InputError(fmt::format("--picture-size is {}: it must be width and height in pixels, 1 to {}, as in 1280x960",
                                 quoted_word(arguments.picture_size), largest));
  }
  picture.render.width = static_cast<int>(size[0]);
  picture.render.height = static_cast<int>(size[1]);
  picture.principal = arguments.view == "principal";
  if (picture.principal) return picture;
  const std::vector<double> direction = numbers_in(arguments.view, ',');
  if (direction.size() != 3) {
    throw InputError(fmt::format("--view is {}: it must be the direction to the viewer, as in 0,0,1, or principal",
                                 quoted_word(arguments.view)));
  }
  picture.render.towards_viewer = Eigen::Vector3d(direction[0], direction[1], direction[2]);
  // Seen from straight above or below, the back of the shape is up.
  if (picture.render.towards_viewer.cross(picture.render.up).norm() <= 1e-6 * picture.render.towards_viewer.norm()) {
    picture.render.up = -Eigen::Vector3d::UnitZ();
  }
  return picture;
}

bool is_offset_sdf(const SdfArguments& arguments) { return arguments.method == "offset_sdf"; }

/// The field that is asked for. `offset`: of the offset SDF; none: automatic.
Field wanted_field(const SdfArguments& arguments, std::optional<double> offset) {
  FieldSettings settings = field_settings(arguments.method);
  settings.samples.site = arguments.site == "vertices" ? SampleSite::vertices : SampleSite::faces;
  settings.values = parameter_values(settings.values.parameters(), arguments.settings, "--method " + arguments.method);
  if (is_offset_sdf(arguments))
    settings.values.set("offset", offset ? ParameterValue(*offset) : ParameterValue("auto"));
  return make_field(std::move(settings));
}

/// What was computed of a shape.
struct Computed {
  std::optional<ChosenOffset> chosen;  ///< with the offset method only
  Samples samples;
  FieldValues field;
};

/// Errors name the input.
Computed compute(const SdfArguments& arguments, std::optional<double> given_offset, const Shape& shape,
                 const std::string& input) {
  try {
    Computed computed;
    if (is_offset_sdf(arguments)) computed.chosen = choose_offset(given_offset, shape);
    const Field field =
        wanted_field(arguments, computed.chosen ? std::optional(computed.chosen->offset) : std::nullopt);
    computed.samples = take_samples(shape, field.settings.samples);
    FieldSource source(shape);
    computed.field = field.compute(source, computed.samples, true);
    return computed;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", input, error.what()));
  }
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

void remark_on(const FieldOutcomes& outcomes, Remarks& remarks) {
  for (std::string& warning : outcome_warnings(outcomes)) remarks.warnings.push_back(std::move(warning));
}

/// Adds an option for each parameter of the two methods.
void add_settings(CLI::App& command, SdfArguments& arguments) {
  for (const std::string_view method : methods) {
    for (const Parameter& parameter : field_types().at(method).parameters) {
      if (parameter.name == "offset") continue;
      const bool angle = parameter.name == "opening_angle_degrees";
      add_parameter_option(command, parameter, arguments.settings[std::string(parameter.name)],
                           angle ? "--opening-angle-degrees,--opening-angle" : "",
                           fmt::format("{}: {}", method, meaning_of(parameter)));
    }
  }
}

int run(SdfArguments& arguments) {
  if (!arguments.timings.empty() && arguments.files.inputs.size() > 1) {
    throw InputError("--timings goes with one shape; leave it out for several");
  }
  const FieldPicture picture = picture_of(arguments);
  const std::optional<double> given_offset = is_offset_sdf(arguments) ? parse_offset(arguments.offset) : std::nullopt;
  wanted_field(arguments, given_offset);  // reports wrong settings before any file is read
  const FieldFileWriter write = field_file_writer(output_name(arguments.files), picture);
  arguments.files.others = {{.path = arguments.timings, .what = "--timings", .extensions = {".json"}}};
  return for_each_shape(arguments.files, [&](const Shape& given, const ShapeJob& job, Remarks& remarks) {
    const Shape shape = arguments.denoise ? denoised_with_remark(given, remarks) : given;
    const Computed computed = compute(arguments, given_offset, shape, job.input);
    write(job.output, shape, computed.samples, computed.field.values);
    remark_on_polygons(shape, computed.samples.site, remarks);
    if (!arguments.timings.empty()) write_timings(arguments.timings, shape, job.read_seconds, computed);
    if (computed.chosen) remark_on(*computed.chosen, remarks);
    remark_on(computed.field.outcomes, remarks);
  });
}

}  // namespace

void add_sdf_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("sdf", "Compute the shape diameter function of shapes, in the files' units");
  command->footer(
      "Example: shapegauge sdf bunny.off --method offset_sdf --offset 0.03 -o bunny.ply\n"
      "         shapegauge sdf models/*.off --method cone_sdf -o sdf/");
  const auto arguments = std::make_shared<SdfArguments>();
  add_shape_inputs(*command, arguments->files);
  command
      ->add_option("--method", arguments->method,
                   "offset_sdf (or offset): of the offset surface; cone_sdf (or cone): conventional")
      ->required()
      ->check(CLI::IsMember({"offset_sdf", "cone_sdf", "offset", "cone"}));
  add_shape_outputs(*command, arguments->files,
                    ".csv (index,sdf,weight), .npy, .ply (coloured mesh or points) or .png (picture)");
  command->add_option("--at", arguments->site, "Where on a mesh; a point cloud is measured at its points")
      ->check(CLI::IsMember({"faces", "vertices"}))
      ->capture_default_str();
  CLI::Option* const offset = add_offset_option(*command, arguments->offset);
  add_settings(*command, *arguments);
  add_denoise_option(*command, arguments->denoise);
  command->add_option("--picture-size", arguments->picture_size, "Width and height of a .png in pixels")
      ->capture_default_str();
  command
      ->add_option("--view", arguments->view,
                   "Direction from the shape to the viewer of a .png, or principal: along the shape's own axes")
      ->capture_default_str();
  command->add_option("--timings", arguments->timings,
                      "JSON file for the times taken, the samples' outcomes, and what 'info' tells of the shape");
  command->callback([arguments, &status, offset] {
    if (!arguments->method.ends_with("_sdf")) arguments->method += "_sdf";
    if (!is_offset_sdf(*arguments) && offset->count() > 0) {
      throw InputError("--offset does not go with --method " + arguments->method);
    }
    status = run(*arguments);
  });
}

}  // namespace shapegauge
