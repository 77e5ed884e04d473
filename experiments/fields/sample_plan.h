#pragma once

#include <Eigen/Core>
#include <compare>
#include <nlohmann/json.hpp>

#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

/// Where a field takes its samples.
struct SamplePlan {
  SampleSite site = SampleSite::faces;
  Eigen::Index count = 0;  ///< surface: how many

  auto operator<=>(const SamplePlan&) const = default;
};

/// The setting "at" of fields: "faces" (default), "vertices" or {"surface": number of samples}.
SamplePlan sample_plan_of(const nlohmann::json& settings);

/// The setting that the plan was read from.
nlohmann::json to_json(const SamplePlan& plan);

/// The samples of a shape that the plan asks for (sample_shape, sample_surface_of).
Samples take_samples(const Shape& shape, const SamplePlan& plan);

}  // namespace shapegauge
