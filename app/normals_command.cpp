#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>

#include "app/commands.h"
#include "app/options.h"
#include "app/shape_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/experiments/results/field_files.h"

namespace shapegauge {

namespace {

struct NormalsArguments {
  ShapeFiles files{.output_format = "csv"};
  std::string site = "vertices";
  std::string offset = "auto";
  bool denoise = false;
};

/// Samples with the outside about as near on both sides: less than half the offset more to go on the other one. Which
/// of the two is taken for outward is left to the input's orientation or to chance. So it is where an offset leaks into
/// a shape (of clouds of random points, this counts 99 % of the samples) and on sheets; never on a closed mesh.
Eigen::Index two_sided(const Shape& shape, const OffsetSdfResult& result, double offset) {
  if (is_watertight(shape)) return 0;
  return (result.values.array() < 0.5 * offset).count();
}

void remark_on(const Shape& shape, const OffsetSdfResult& result, double offset, Remarks& remarks) {
  const OffsetSdfOutcomes& outcomes = result.outcomes;
  if (const Eigen::Index count = two_sided(shape, result, offset); count > 0) {
    remarks.warnings.push_back(
        fmt::format("{} of {} samples have the outside about as near on both sides: which way their normals point is "
                    "left to the input's orientation or to chance",
                    count, outcomes.total));
  }
  if (outcomes.undecided > 0) {
    remarks.warnings.push_back(fmt::format("{} of {} samples undecided", outcomes.undecided, outcomes.total));
  }
  if (outcomes.missing > 0) {
    remarks.warnings.push_back(fmt::format("{} of {} samples missing", outcomes.missing, outcomes.total));
  }
}

void write_normals(const NormalsArguments& arguments, const NormalFileWriter& write, std::optional<double> given_offset,
                   const Shape& given, const ShapeJob& job, Remarks& remarks) {
  try {
    const Shape shape = arguments.denoise ? denoised_with_remark(given, remarks) : given;
    const Samples samples = sample_shape(shape, arguments.site == "faces" ? SampleSite::faces : SampleSite::vertices);
    const ChosenOffset chosen = choose_offset(given_offset, shape);
    const OffsetSdfResult result = offset_sdf(shape, samples, {.offset = chosen.offset});
    write(job.output, shape, samples, result.normals);
    remark_on_polygons(shape, samples.site, remarks);
    remark_on(chosen, remarks);
    remark_on(shape, result, chosen.offset * bounding_box_diagonal(shape), remarks);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", job.input, error.what()));
  }
}

}  // namespace

void add_normals_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("normals", "Estimate the outward normals of shapes, however noisy, cracked or turned");
  command->footer(
      "Example: shapegauge normals scan.xyz -o scan.ply\n"
      "         shapegauge normals scans/*.ply --output-format xyz -o normals/");
  const auto arguments = std::make_shared<NormalsArguments>();
  add_shape_inputs(*command, arguments->files);
  add_shape_outputs(*command, arguments->files,
                    ".csv (index,nx,ny,nz,weight), .npy, .ply (the shape with normals) or .xyz (points with normals)");
  command->add_option("--at", arguments->site, "Where on a mesh; a point cloud has them at its points")
      ->check(CLI::IsMember({"faces", "vertices"}))
      ->capture_default_str();
  add_offset_option(*command, arguments->offset);
  add_denoise_option(*command, arguments->denoise);
  command->callback([arguments, &status] {
    const std::optional<double> given = parse_offset(arguments->offset);
    const NormalFileWriter write = normal_file_writer(output_name(arguments->files));
    status = for_each_shape(arguments->files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
      write_normals(*arguments, write, given, shape, job, remarks);
    });
  });
}

}  // namespace shapegauge
