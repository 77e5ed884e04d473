#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of what views hold: what a cache holds of earlier versions is then made anew.
inline constexpr int model_view_version = 1;

/// The most models of which a report has views.
inline constexpr std::size_t most_models_with_views = 2000;

/// How many faces a view in a report has: fewer, the more models there are, so that all of them take a few megabytes.
Eigen::Index faces_of_views(std::size_t models);

/// The values of a field at samples of a shape.
struct SampledField {
  const Samples& samples;
  const Eigen::VectorXd& values;
};

/// A shape of at most so many faces, or points of a cloud, with the fields at its vertices, as JSON (shape_view_json())
/// without names. Depends on nothing else. Throws as coarse_shape() and shape_view_json().
std::string model_view(const Shape& shape, std::span<const SampledField> fields, Eigen::Index faces);

}  // namespace shapegauge
