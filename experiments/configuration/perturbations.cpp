#include "shapegauge/experiments/configuration/perturbations.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/perturbation/sample_surface.h"
#include "shapegauge/experiments/configuration/nearest_word.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using Choices = std::vector<std::vector<Perturbation>>;

/// Parameters that several steps have.
constexpr Bounds fractions{.low = 0, .high = 1};

constexpr std::array<std::string_view, 2> distributions{"uniform", "gaussian"};

PerturbationType vertex_noise_type() {
  return {
      .name = "vertex_noise",
      .description =
          "Moves every vertex (or point) by a random vector; vertices at the same place part unless "
          "they are one.",
      .parameters = {{.name = "amplitude",
                      .bounds = fractions,
                      .description = "As a fraction of the bounding box's diagonal."},
                     {.name = "distribution",
                      .kind = ParameterKind::choice,
                      .default_value = distributions[0],
                      .choices = distributions,
                      .description = "uniform: in the ball whose radius is the amplitude; gaussian: each coordinate "
                                     "has the amplitude as its standard deviation."}},
      .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
        const bool uniform = values.word("distribution") == "uniform";
        const VertexNoiseOptions options{
            .amplitude = values.number("amplitude"),
            .distribution = uniform ? NoiseDistribution::uniform : NoiseDistribution::gaussian};
        return [options](Shape shape, PerturbationContext& context) {
          return vertex_noise(std::move(shape), options, context.random);
        };
      }};
}

PerturbationType remove_faces_type() {
  return {.name = "remove_faces",
          .description = "Removes random faces (or points).",
          .parameters = {{.name = "fraction",
                          .bounds = fractions,
                          .description = "How much of them, rounded to a whole number."}},
          .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
            return [fraction = values.number("fraction")](Shape shape, PerturbationContext& context) {
              return remove_faces(std::move(shape), fraction, context.random);
            };
          }};
}

PerturbationType holes_type() {
  const PunchHolesOptions usual;
  return {.name = "holes",
          .description = "Removes the faces (or points) near random points of the surface.",
          .parameters = {{.name = "number",
                          .kind = ParameterKind::integer,
                          .default_value = std::int64_t{usual.number},
                          .bounds = {.low = 0, .high = 100'000},
                          .description = "Number of points."},
                         {.name = "radius",
                          .default_value = usual.radius,
                          .bounds = fractions,
                          .description = "As a fraction of the bounding box's diagonal."}},
          .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
            const PunchHolesOptions options{.number = static_cast<int>(values.integer("number")),
                                            .radius = values.number("radius")};
            return [options](Shape shape, PerturbationContext& context) {
              return punch_holes(std::move(shape), options, context.random);
            };
          }};
}

PerturbationType decimate_type() {
  return {.name = "decimate",
          .description =
              "Simplifies the mesh by edge collapses in order of their quadric error; never opens a closed "
              "mesh.",
          .parameters = {{.name = "faces",
                          .kind = ParameterKind::integer,
                          .bounds = {.low = 1, .high = 100'000'000},
                          .description = "Number of faces that are left, at most."}},
          .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
            return [faces = values.integer("faces")](const Shape& shape, PerturbationContext& /*context*/) {
              return decimate(shape, faces);
            };
          }};
}

PerturbationType sample_points_type() {
  const SampleSurfaceOptions usual;
  return {.name = "sample_points",
          .description = "Makes a point cloud of the mesh: random points, uniform by area.",
          .parameters = {{.name = "points",
                          .kind = ParameterKind::integer,
                          .default_value = std::int64_t{usual.points},
                          .bounds = {.low = 1, .high = 100'000'000},
                          .description = "Number of points."},
                         {.name = "with_normals",
                          .kind = ParameterKind::boolean,
                          .default_value = usual.with_normals,
                          .description = "Whether the points have their triangles' normals."}},
          .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
            const SampleSurfaceOptions options{.points = values.integer("points"),
                                               .with_normals = values.boolean("with_normals")};
            return [options](const Shape& shape, PerturbationContext& context) {
              return sample_surface(shape, options, context.random);
            };
          }};
}

PerturbationType vertex_cloud_type() {
  return {.name = "vertex_cloud",
          .description = "Makes a point cloud of the vertices that a triangle uses.",
          .parameters = {},
          .make = [](const ParameterValues& /*values*/, const Choices& /*choices*/) -> PerturbationFunction {
            return [](const Shape& shape, PerturbationContext& /*context*/) { return vertex_cloud(shape); };
          }};
}

PerturbationType flip_orientation_type() {
  return {.name = "flip_orientation",
          .description = "Turns random faces (or normals) over.",
          .parameters = {{.name = "fraction",
                          .default_value = 1.0,
                          .bounds = fractions,
                          .description = "How much of them, rounded to a whole number."}},
          .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
            return [fraction = values.number("fraction")](Shape shape, PerturbationContext& context) {
              return flip_orientation(std::move(shape), fraction, context.random);
            };
          }};
}

PerturbationType motion_type() {
  return {.name = "motion",
          .description = "Rotates and shifts at random, and scales at random.",
          .parameters = {{.name = "scale",
                          .default_value = 1.0,
                          .bounds = {.low = 1, .high = 1e6},
                          .description = "The scale is between 1/scale and scale, uniform in its logarithm."}},
          .make = [](const ParameterValues& values, const Choices& /*choices*/) -> PerturbationFunction {
            return [scale = values.number("scale")](Shape shape, PerturbationContext& context) {
              return random_motion(std::move(shape), scale, context.random);
            };
          }};
}

constexpr std::array<std::string_view, 2> assignments{"random", "in_turn"};

PerturbationType one_of_type() {
  return {
      .name = "one_of",
      .description = "Gives each model one of the lists of steps in its `choices`.",
      .parameters = {{.name = "assign",
                      .kind = ParameterKind::choice,
                      .default_value = assignments[0],
                      .choices = assignments,
                      .description = "random: drawn for each model; in_turn: by the model's place in the data set."}},
      .make = [](const ParameterValues& values, Choices choices) -> PerturbationFunction {
        const bool in_turn = values.word("assign") == "in_turn";
        return [in_turn, choices = std::move(choices)](Shape shape, PerturbationContext& context) {
          const auto count = choices.size();
          const auto drawn = static_cast<std::size_t>(context.random.uniform(0, static_cast<double>(count)));
          const std::size_t choice = in_turn ? context.model % count : std::min(drawn, count - 1);
          context.chosen->push_back(choice);
          return apply_perturbations(std::move(shape), choices[choice], context);
        };
      },
      .has_choices = true};
}

std::vector<PerturbationType>& registry() {
  static std::vector<PerturbationType> types{vertex_noise_type(),     remove_faces_type(),  holes_type(),
                                             decimate_type(),         sample_points_type(), vertex_cloud_type(),
                                             flip_orientation_type(), motion_type(),        one_of_type()};
  return types;
}

/// 64-bit FNV-1a: the same number everywhere, which std::hash does not promise.
std::uint64_t stable_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

Shape apply_perturbations(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& parent) {
  for (const Perturbation& step : steps) {
    PerturbationContext own{
        .random = RandomNumbers(parent.random.next()), .model = parent.model, .chosen = parent.chosen};
    shape = step.apply(std::move(shape), own);
  }
  return shape;
}

PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model) {
  PerturbedShape perturbed;
  PerturbationContext context{
      .random = RandomNumbers(seed, stable_hash(id)), .model = model, .chosen = &perturbed.chosen};
  perturbed.shape = apply_perturbations(std::move(shape), steps, context);
  return perturbed;
}

std::span<const PerturbationType> perturbation_types() { return registry(); }

void register_perturbation(PerturbationType type) {
  const auto reserved = [](const Parameter& parameter) {
    return parameter.name == "type" || parameter.name == "choices";
  };
  const bool known = std::ranges::find(registry(), type.name, &PerturbationType::name) != registry().end();
  if (type.name.empty() || known || !type.make || std::ranges::any_of(type.parameters, reserved)) {
    throw std::invalid_argument(fmt::format(
        "a perturbation needs a name of its own, a function, and parameters that are not called type or choices: "
        "\"{}\"",
        type.name));
  }
  registry().push_back(std::move(type));
}

Perturbation make_perturbation(const Json& settings) {
  const std::string name = settings.at("type");
  const auto type = std::ranges::find(registry(), name, &PerturbationType::name);
  if (type == registry().end()) {
    std::vector<std::string> names;
    for (const PerturbationType& known : registry()) names.push_back(known.name);
    throw InputError(fmt::format("there is no perturbation of type \"{}\"{}", name, suggestion(name, names)));
  }
  const ParameterValues values = read_parameters(type->parameters, settings);
  Perturbation step{.settings = to_json(values), .versions = {{name, type->version}}, .apply = {}};
  step.settings["type"] = name;
  Choices choices;
  if (type->has_choices) {
    step.settings["choices"] = Json::array();
    for (const Json& choice : settings.at("choices")) {
      const std::vector<Perturbation>& steps = choices.emplace_back(make_perturbations(choice));
      step.settings["choices"].push_back(to_json(steps));
      for (const Perturbation& chosen : steps) step.versions.update(chosen.versions);
    }
  }
  step.apply = type->make(values, std::move(choices));
  return step;
}

std::vector<Perturbation> make_perturbations(const Json& list) {
  std::vector<Perturbation> steps;
  for (const Json& settings : list) steps.push_back(make_perturbation(settings));
  return steps;
}

Json to_json(const std::vector<Perturbation>& steps) {
  Json list = Json::array();
  for (const Perturbation& step : steps) list.push_back(step.settings);
  return list;
}

}  // namespace shapegauge
