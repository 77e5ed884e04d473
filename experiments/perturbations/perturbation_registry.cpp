#include "shapegauge/experiments/perturbations/perturbation_registry.h"

#include <array>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/perturbations/one_of.h"
#include "shapegauge/experiments/perturbations/simple_perturbations.h"

namespace shapegauge {

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
