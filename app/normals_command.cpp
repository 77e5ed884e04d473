#include "app/normals_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <utility>

#include "app/options.h"
#include "app/run_program.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/offset_normals.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct NormalsArguments {
  fs::path input;
  fs::path output;
  std::string site = "vertices";
  std::string offset = "0.03";
  bool denoise = false;
  int threads = 0;
};

void warn_of(const OffsetSdfOutcomes& outcomes) {
  if (outcomes.undecided > 0) {
    fmt::print(stderr, "shapegauge: warning: {} of {} samples undecided\n", outcomes.undecided, outcomes.total);
  }
  if (outcomes.missing > 0) {
    fmt::print(stderr, "shapegauge: warning: {} of {} samples missing\n", outcomes.missing, outcomes.total);
  }
}

void compute_and_write(const NormalsArguments& arguments, std::optional<double> given, const NormalFileWriter& write) {
  Shape shape = read_shape(arguments.input);
  if (arguments.denoise) shape = denoised_with_report(std::move(shape));
  try {
    const Samples samples = sample_shape(shape, arguments.site == "faces" ? SampleSite::faces : SampleSite::vertices);
    const ChosenOffset chosen = choose_offset(given, shape);
    const OffsetNormals result = offset_normals(shape, samples, {.offset = chosen.offset});
    write(arguments.output, shape, samples, result.normals);
    report(chosen);
    warn_of(result.outcomes);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", arguments.input.string(), error.what()));
  }
}

int run(const NormalsArguments& arguments) {
  const NormalFileWriter write = normal_file_writer(arguments.output);
  const std::optional<double> given = parse_offset(arguments.offset);
  with_threads(arguments.threads, [&] { compute_and_write(arguments, given, write); });
  return exit_success;
}

}  // namespace

void add_normals_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("normals", "Estimate the outward normals of a shape, however noisy, cracked or turned");
  command->footer("Example: shapegauge normals scan.xyz --offset auto -o scan.ply");
  const auto arguments = std::make_shared<NormalsArguments>();
  add_shape_argument(*command, arguments->input);
  command
      ->add_option("-o,--output", arguments->output,
                   "Result: .csv (index,nx,ny,nz,weight), .npy, .ply (the shape with normals) or .xyz (points with "
                   "normals)")
      ->required();
  command->add_option("--at", arguments->site, "Where on a mesh; a point cloud has them at its points")
      ->check(CLI::IsMember({"faces", "vertices"}))
      ->capture_default_str();
  command
      ->add_option("--offset", arguments->offset,
                   "Offset distance as a fraction of the bounding-box diagonal, or auto: by the gaps and the noise")
      ->capture_default_str();
  command->add_flag("--denoise", arguments->denoise, "Smooth a mesh first whose vertices are noisy beyond doubt");
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
