#pragma once

#include <Eigen/Core>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/configuration/configuration.h"

namespace shapegauge {

/// To be raised with every change of what pictures look like, or of what it rests on (render_shape, principal_view,
/// colours): what a cache holds of earlier versions is then drawn anew.
inline constexpr int picture_version = 3;

/// A small picture of a shape in its principal_view(), coloured by the values of a field at the samples on it, as the
/// bytes of a PNG file with a transparent background. Depends on nothing else. Samples that are neither at all faces
/// nor at all vertices are drawn as a cloud of points. Throws as render_shape().
std::string model_picture(const Shape& shape, const Samples& samples, const Eigen::VectorXd& values,
                          const PictureOptions& options);

}  // namespace shapegauge
