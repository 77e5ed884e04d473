#include "shapegauge/experiments/command_line/sdf_command.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/experiments/command_line/exit_status.h"
#include "shapegauge/experiments/fields/field_registry.h"
#include "shapegauge/experiments/results/diagnostics_json.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/experiments/runner/with_threads.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct SdfArguments {
  fs::path input;
  fs::path output;
  std::string method;
  std::string site = "faces";
  double offset = 0.05;
  std::string engine = "embree";
  double opening_angle = 60;
  int rays = 25;
  int threads = 0;
  fs::path timings;
};

nlohmann::json field_settings(const SdfArguments& arguments) {
  if (arguments.method == "offset") {
    return {{"type", "offset_sdf"}, {"offset", arguments.offset}, {"at", arguments.site}};
  }
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

void write_timings(const fs::path& path, const Shape& shape, double read_seconds, const FieldValues& computed) {
  const nlohmann::ordered_json timings{{"read_seconds", read_seconds},
                                       {"build_seconds", computed.build_seconds},
                                       {"query_seconds", computed.query_seconds},
                                       {"samples", computed.outcomes},
                                       {"shape", diagnostics_json(diagnose(shape))}};
  write_file_atomically(path, timings.dump(2) + "\n");
}

/// The field's values and where they are; what is wrong with the shape is told with the file's name.
std::pair<Samples, FieldValues> compute(const Field& field, const Shape& shape, const fs::path& file) {
  try {
    Samples samples = take_samples(shape, field.samples);
    FieldValues computed = field.compute(shape, samples, true);
    return {std::move(samples), std::move(computed)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

int run(const SdfArguments& arguments) {
  const FieldFileWriter write = field_file_writer(arguments.output);
  const Field field = make_field(field_settings(arguments));
  const auto start = std::chrono::steady_clock::now();
  const Shape shape = read_shape(arguments.input);
  const double read_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  with_threads(arguments.threads, [&] {
    const auto [samples, computed] = compute(field, shape, arguments.input);
    write(arguments.output, shape, samples, computed.values);
    if (!arguments.timings.empty()) write_timings(arguments.timings, shape, read_seconds, computed);
    warn_of(computed.outcomes);
  });
  return exit_success;
}

}  // namespace

void add_sdf_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("sdf", "Compute the shape diameter function of a shape, in the file's units");
  command->footer("Example: shapegauge sdf bunny.off --method offset --offset 0.03 -o bunny.ply");
  const auto arguments = std::make_shared<SdfArguments>();
  command->add_option("input", arguments->input, "Mesh or point cloud: OFF, OBJ, PLY, STL, XYZ, PWN, PTS or TXT")
      ->required();
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
      command->add_option("--offset", arguments->offset, "Offset distance as a fraction of the bounding-box diagonal");
  offset->capture_default_str();
  std::vector<CLI::Option*> of_cone{
      command->add_option("--engine", arguments->engine, "cone: who casts the rays")
          ->check(CLI::IsMember({"embree", "cgal"})),
      command->add_option("--opening-angle", arguments->opening_angle, "cone: opening angle in degrees"),
      command->add_option("--rays", arguments->rays, "cone: rays for each sample")};
  for (CLI::Option* option : of_cone) option->capture_default_str();
  command->add_option("--threads", arguments->threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
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
