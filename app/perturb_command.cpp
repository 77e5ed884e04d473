#include <CLI/CLI.hpp>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/commands.h"
#include "app/options.h"
#include "app/shape_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/configuration/perturbations.h"

namespace shapegauge {

namespace {

struct PerturbArguments {
  ShapeFiles files{.output_format = "off"};
  std::uint64_t seed = 1;
  std::optional<int> faces;
  std::optional<double> noise;
  std::optional<double> removed;
  std::optional<int> holes;
  double hole_radius = 0.05;
  std::optional<int> points;
  bool with_normals = false;
  std::optional<double> flipped;
  std::optional<double> scale;
};

/// The steps, in the order that the help gives.
nlohmann::json steps_of(const PerturbArguments& arguments) {
  nlohmann::json steps = nlohmann::json::array();
  if (arguments.faces) steps.push_back({{"type", "decimate"}, {"faces", *arguments.faces}});
  if (arguments.noise) steps.push_back({{"type", "vertex_noise"}, {"amplitude", *arguments.noise}});
  if (arguments.removed) steps.push_back({{"type", "remove_faces"}, {"fraction", *arguments.removed}});
  if (arguments.holes) {
    steps.push_back({{"type", "holes"}, {"number", *arguments.holes}, {"radius", arguments.hole_radius}});
  }
  if (arguments.points) {
    steps.push_back(
        {{"type", "sample_points"}, {"points", *arguments.points}, {"with_normals", arguments.with_normals}});
  }
  if (arguments.flipped) steps.push_back({{"type", "flip_orientation"}, {"fraction", *arguments.flipped}});
  if (arguments.scale) steps.push_back({{"type", "motion"}, {"scale", *arguments.scale}});
  return steps;
}

int run(const PerturbArguments& arguments) {
  const ShapeWriter write = shape_writer(output_name(arguments.files));
  const std::vector<Perturbation> steps = make_perturbations(steps_of(arguments));
  if (steps.empty()) throw InputError("nothing to do: name at least one change; see 'shapegauge perturb --help'");
  return for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks& /*remarks*/) {
    write(job.output, perturb_model(shape, steps, arguments.seed, "", 0).shape);
  });
}

}  // namespace

void add_perturb_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "perturb", "Change a shape at random: noise, holes, fewer faces, points. Changes are made in the order below.");
  command->footer("Example: shapegauge perturb bunny.off -o worse.off --noise 0.005 --remove-faces 0.15 --seed 7");
  const auto arguments = std::make_shared<PerturbArguments>();
  add_shape_inputs(*command, arguments->files);
  add_shape_outputs(*command, arguments->files, fmt::format("{}", fmt::join(written_shape_extensions(), ", ")));
  add_seed_option(*command, arguments->seed);
  command->add_option("--decimate", arguments->faces, "Simplify the mesh to so many faces");
  command->add_option("--noise", arguments->noise,
                      "Move every vertex, at random in a ball of this radius, a fraction of the diagonal");
  command->add_option("--remove-faces", arguments->removed, "Remove this fraction of the faces (of a cloud: points)");
  CLI::Option* holes = command->add_option("--holes", arguments->holes, "Punch so many holes");
  command->add_option("--hole-radius", arguments->hole_radius, "Their radius, as a fraction of the diagonal")
      ->needs(holes)
      ->capture_default_str();
  CLI::Option* points = command->add_option("--points", arguments->points, "Sample so many points: a point cloud");
  command->add_flag("--with-normals", arguments->with_normals, "Give the points normals")->needs(points);
  command->add_option("--flip", arguments->flipped, "Turn this fraction of the faces over (of a cloud: normals)");
  command->add_option("--motion", arguments->scale,
                      "Rotate and shift, and scale by a factor from 1/MOTION to MOTION (1: no scaling)");
  command->callback([arguments, &status] { status = run(*arguments); });
}

void add_convert_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("convert", "Write shapes in another format");
  command->footer(
      "Example: shapegauge convert bunny.stl -o bunny.off\n"
      "         shapegauge convert scans/*.obj --output-format ply -o ply/\n"
      "Polygons become triangles; the normals of point clouds are kept, colours and textures are not.");
  const auto files = std::make_shared<ShapeFiles>(ShapeFiles{.output_format = "off"});
  add_shape_inputs(*command, *files);
  add_shape_outputs(*command, *files, fmt::format("{}", fmt::join(written_shape_extensions(), ", ")));
  command->callback([files, &status] {
    const ShapeWriter write = shape_writer(output_name(*files));
    status = for_each_shape(
        *files, [&](const Shape& shape, const ShapeJob& job, Remarks& /*remarks*/) { write(job.output, shape); });
  });
}

}  // namespace shapegauge
