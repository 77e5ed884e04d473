#include "app/sdf_command.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <utility>

#include "app/options.h"
#include "app/run_program.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/experiments/results/shape_tables.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct SdfArguments {
  fs::path input;
  fs::path output;
  std::string method;
  std::string site = "faces";
  std::string offset = "0.05";
  std::string engine = "embree";
  double opening_angle = 60;
  int rays = 25;
  bool denoise = false;
  int threads = 0;
  fs::path timings;
};

/// `chosen`: with the offset method only.
nlohmann::json field_settings(const SdfArguments& arguments, const std::optional<ChosenOffset>& chosen) {
  if (chosen) return {{"type", "offset_sdf"}, {"offset", chosen->offset}, {"at", arguments.site}};
  return {{"type", "cone_sdf"},
          {"engine", arguments.engine},
          {"opening_angle_degrees", arguments.opening_angle},
          {"rays", arguments.rays},
          {"at", arguments.site}};
}

void warn_of(const FieldOutcomes& outcomes) {
  for (const char* outcome : {"undecided", "missing"}) {
    const auto count = outcomes.find(outcome);
    if (count == outcomes.end() || count->second == 0) continue;
    fmt::print(stderr, "shapegauge: warning: {} of {} samples {}\n", count->second, outcomes.at("total"), outcome);
  }
}

/// What was computed of a shape.
struct Computed {
  std::optional<ChosenOffset> chosen;  ///< with the offset method only
  Samples samples;
  FieldValues field;
};

void write_timings(const fs::path& path, const Shape& shape, double read_seconds, const Computed& computed) {
  nlohmann::ordered_json timings{{"read_seconds", read_seconds},
                                 {"build_seconds", computed.field.build_seconds},
                                 {"query_seconds", computed.field.query_seconds},
                                 {"samples", computed.field.outcomes}};
  if (computed.chosen) timings["offset"] = to_json(*computed.chosen);
  timings["shape"] = diagnostics_json(diagnose(shape));
  write_file_atomically(path, timings.dump(2) + "\n");
}

/// What is wrong with the shape is told with the file's name.
Computed compute(const SdfArguments& arguments, std::optional<double> given_offset, const Shape& shape) {
  try {
    Computed computed;
    if (arguments.method == "offset") computed.chosen = choose_offset(given_offset, shape);
    const Field field = make_field(field_settings(arguments, computed.chosen));
    computed.samples = take_samples(shape, field.samples);
    FieldSource source(shape);
    computed.field = field.compute(source, computed.samples, true);
    return computed;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", arguments.input.string(), error.what()));
  }
}

int run(const SdfArguments& arguments) {
  const FieldFileWriter write = field_file_writer(arguments.output);
  const std::optional<double> given_offset = parse_offset(arguments.offset);
  const auto start = std::chrono::steady_clock::now();
  Shape shape = read_shape(arguments.input);
  const double read_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (arguments.denoise) shape = denoised_with_report(std::move(shape));
  with_threads(arguments.threads, [&] {
    const Computed computed = compute(arguments, given_offset, shape);
    write(arguments.output, shape, computed.samples, computed.field.values);
    if (!arguments.timings.empty()) write_timings(arguments.timings, shape, read_seconds, computed);
    if (computed.chosen) report(*computed.chosen);
    warn_of(computed.field.outcomes);
  });
  return exit_success;
}

}  // namespace

void add_sdf_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("sdf", "Compute the shape diameter function of a shape, in the file's units");
  command->footer("Example: shapegauge sdf bunny.off --method offset --offset 0.03 -o bunny.ply");
  const auto arguments = std::make_shared<SdfArguments>();
  add_shape_argument(*command, arguments->input);
  command->add_option("--method", arguments->method, "offset: of the offset surface; cone: conventional")
      ->required()
      ->check(CLI::IsMember({"offset", "cone"}));
  command
      ->add_option("-o,--output", arguments->output,
                   "Result: .csv (index,sdf,weight), .npy, .ply (coloured mesh or points) or .png (picture)")
      ->required();
  command->add_option("--at", arguments->site, "Where on a mesh; a point cloud is measured at its points")
      ->check(CLI::IsMember({"faces", "vertices"}))
      ->capture_default_str();
  CLI::Option* offset =
      command->add_option("--offset", arguments->offset,
                          "Offset distance as a fraction of the bounding-box diagonal, or auto: by the gaps and noise");
  offset->capture_default_str();
  std::vector<CLI::Option*> of_cone{
      command->add_option("--engine", arguments->engine, "cone: who casts the rays")
          ->check(CLI::IsMember({"embree", "cgal"})),
      command->add_option("--opening-angle", arguments->opening_angle, "cone: opening angle in degrees"),
      command->add_option("--rays", arguments->rays, "cone: rays for each sample")};
  for (CLI::Option* option : of_cone) option->capture_default_str();
  command->add_flag("--denoise", arguments->denoise, "Smooth a mesh first whose vertices are noisy beyond doubt");
  add_threads_option(*command, arguments->threads);
  command->add_option("--timings", arguments->timings,
                      "JSON file for the times taken, the samples' outcomes, and what 'info' tells of the shape");
  command->callback([arguments, &status, offset, of_cone] {
    const bool is_offset = arguments->method == "offset";
    for (const CLI::Option* option : of_cone) {
      if (is_offset && option->count() > 0) throw InputError(option->get_name() + " goes with --method cone only");
    }
    if (!is_offset && offset->count() > 0) throw InputError("--offset goes with --method offset only");
    status = run(*arguments);
  });
}

}  // namespace shapegauge
