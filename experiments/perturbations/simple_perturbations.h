#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/experiments/perturbations/perturbation.h"

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

}  // namespace shapegauge
