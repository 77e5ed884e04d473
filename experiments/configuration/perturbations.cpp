#include "shapegauge/experiments/configuration/perturbations.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/perturbation/sample_surface.h"

namespace shapegauge {

/// The perturbation types that are a function of core/perturbation each, by their settings:
/// "vertex_noise": `amplitude` and `distribution` of vertex_noise;
Perturbation vertex_noise_step(const nlohmann::json& settings);
/// "remove_faces": `fraction` of remove_faces;
Perturbation remove_faces_step(const nlohmann::json& settings);
/// "holes": `number` and `radius` of punch_holes;
Perturbation holes_step(const nlohmann::json& settings);
/// "decimate": `faces` of decimate;
Perturbation decimate_step(const nlohmann::json& settings);
/// "sample_points": `points` and `with_normals` of sample_surface;
Perturbation sample_points_step(const nlohmann::json& settings);
/// "vertex_cloud": vertex_cloud, without settings;
Perturbation vertex_cloud_step(const nlohmann::json& settings);
/// "flip_orientation": `fraction` of flip_orientation;
Perturbation flip_orientation_step(const nlohmann::json& settings);
/// "motion": `scale` of random_motion.
Perturbation motion_step(const nlohmann::json& settings);

/// The perturbation type "one_of": applies one of the lists of steps in `choices`: with `assign` "random" one drawn at
/// random for each model, with "in_turn" that of the model's index in the data set modulo their number.
Perturbation one_of_step(const nlohmann::json& settings);

using Json = nlohmann::json;

Perturbation vertex_noise_step(const Json& settings) {
  VertexNoiseOptions options;
  options.amplitude = settings.at("amplitude");
  const bool uniform = settings.value("distribution", "uniform") == "uniform";
  options.distribution = uniform ? NoiseDistribution::uniform : NoiseDistribution::gaussian;
  return {.settings = {{"type", "vertex_noise"},
                       {"amplitude", options.amplitude},
                       {"distribution", uniform ? "uniform" : "gaussian"}},
          .apply = [options](Shape shape, PerturbationContext& context) {
            return vertex_noise(std::move(shape), options, context.random);
          }};
}

Perturbation remove_faces_step(const Json& settings) {
  const double fraction = settings.at("fraction");
  return {.settings = {{"type", "remove_faces"}, {"fraction", fraction}},
          .apply = [fraction](Shape shape, PerturbationContext& context) {
            return remove_faces(std::move(shape), fraction, context.random);
          }};
}

Perturbation holes_step(const Json& settings) {
  PunchHolesOptions options;
  options.number = settings.value("number", options.number);
  options.radius = settings.value("radius", options.radius);
  return {.settings = {{"type", "holes"}, {"number", options.number}, {"radius", options.radius}},
          .apply = [options](Shape shape, PerturbationContext& context) {
            return punch_holes(std::move(shape), options, context.random);
          }};
}

Perturbation decimate_step(const Json& settings) {
  const Eigen::Index faces = settings.at("faces");
  return {.settings = {{"type", "decimate"}, {"faces", faces}},
          .apply = [faces](const Shape& shape, PerturbationContext& /*context*/) { return decimate(shape, faces); }};
}

Perturbation sample_points_step(const Json& settings) {
  SampleSurfaceOptions options;
  options.points = settings.value("points", options.points);
  options.with_normals = settings.value("with_normals", options.with_normals);
  return {.settings = {{"type", "sample_points"}, {"points", options.points}, {"with_normals", options.with_normals}},
          .apply = [options](const Shape& shape, PerturbationContext& context) {
            return sample_surface(shape, options, context.random);
          }};
}

Perturbation vertex_cloud_step(const Json& /*settings*/) {
  return {.settings = {{"type", "vertex_cloud"}},
          .apply = [](const Shape& shape, PerturbationContext& /*context*/) { return vertex_cloud(shape); }};
}

Perturbation flip_orientation_step(const Json& settings) {
  const double fraction = settings.value("fraction", 1.0);
  return {.settings = {{"type", "flip_orientation"}, {"fraction", fraction}},
          .apply = [fraction](Shape shape, PerturbationContext& context) {
            return flip_orientation(std::move(shape), fraction, context.random);
          }};
}

Perturbation motion_step(const Json& settings) {
  const double scale = settings.value("scale", 1.0);
  return {.settings = {{"type", "motion"}, {"scale", scale}},
          .apply = [scale](Shape shape, PerturbationContext& context) {
            return random_motion(std::move(shape), scale, context.random);
          }};
}

Perturbation one_of_step(const nlohmann::json& settings) {
  const bool in_turn = settings.value("assign", "random") == "in_turn";
  std::vector<std::vector<Perturbation>> choices;
  nlohmann::json filled_in = nlohmann::json::array();
  for (const nlohmann::json& choice : settings.at("choices")) {
    filled_in.push_back(to_json(choices.emplace_back(make_perturbations(choice))));
  }
  return {.settings = {{"type", "one_of"}, {"assign", in_turn ? "in_turn" : "random"}, {"choices", filled_in}},
          .apply = [in_turn, choices = std::move(choices)](Shape shape, PerturbationContext& context) {
            const auto drawn = static_cast<std::size_t>(context.random.uniform(0, static_cast<double>(choices.size())));
            const std::size_t choice = in_turn ? context.model % choices.size() : std::min(drawn, choices.size() - 1);
            context.chosen->push_back(choice);
            return apply_perturbations(std::move(shape), choices[choice], context);
          }};
}

namespace {

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

std::span<const PerturbationType> perturbation_types() {
  static constexpr std::array types{
      PerturbationType{"vertex_noise", vertex_noise_step},
      PerturbationType{"remove_faces", remove_faces_step},
      PerturbationType{"holes", holes_step},
      PerturbationType{"decimate", decimate_step},
      PerturbationType{"sample_points", sample_points_step},
      PerturbationType{"vertex_cloud", vertex_cloud_step},
      PerturbationType{"flip_orientation", flip_orientation_step},
      PerturbationType{"motion", motion_step},
      PerturbationType{"one_of", one_of_step},
  };
  return types;
}

Perturbation make_perturbation(const nlohmann::json& settings) {
  const std::string type = settings.at("type");
  for (const PerturbationType& known : perturbation_types()) {
    if (known.name == type) return known.make(settings);
  }
  throw InputError(fmt::format("there is no perturbation of type \"{}\"", type));
}

std::vector<Perturbation> make_perturbations(const nlohmann::json& list) {
  std::vector<Perturbation> steps;
  for (const nlohmann::json& settings : list) steps.push_back(make_perturbation(settings));
  return steps;
}

nlohmann::json to_json(const std::vector<Perturbation>& steps) {
  nlohmann::json list = nlohmann::json::array();
  for (const Perturbation& step : steps) list.push_back(step.settings);
  return list;
}

}  // namespace shapegauge
