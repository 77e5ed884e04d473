#include "shapegauge/experiments/perturbations/simple_perturbations.h"

#include <utility>

#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/flip_orientation.h"
#include "shapegauge/core/perturbation/punch_holes.h"
#include "shapegauge/core/perturbation/random_motion.h"
#include "shapegauge/core/perturbation/remove_faces.h"
#include "shapegauge/core/perturbation/sample_surface.h"
#include "shapegauge/core/perturbation/vertex_cloud.h"
#include "shapegauge/core/perturbation/vertex_noise.h"

namespace shapegauge {

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

}  // namespace shapegauge
