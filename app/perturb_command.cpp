#include "app/perturb_command.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/options.h"
#include "app/run_program.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/configuration/perturbations.h"

namespace shapegauge {

namespace {

struct PerturbArguments {
  std::filesystem::path input;
  std::filesystem::path output;
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
  const ShapeWriter write = shape_writer(arguments.output);
  const std::vector<Perturbation> steps = make_perturbations(steps_of(arguments));
  if (steps.empty()) throw InputError("nothing to do: name at least one change; see 'shapegauge perturb --help'");
  write(arguments.output, perturb_model(read_shape(arguments.input), steps, arguments.seed, "", 0).shape);
  return exit_success;
}

}  // namespace

void add_perturb_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "perturb", "Change a shape at random: noise, holes, fewer faces, points. Changes are made in the order below.");
  command->footer("Example: shapegauge perturb bunny.off -o worse.off --noise 0.005 --remove-faces 0.15 --seed 7");
  const auto arguments = std::make_shared<PerturbArguments>();
  add_shape_argument(*command, arguments->input);
  command->add_option("-o,--output", arguments->output, "Result: .off or .ply")->required();
  command->add_option("--seed", arguments->seed, "The same seed gives the same result")->capture_default_str();
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

}  // namespace shapegauge
