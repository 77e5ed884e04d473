#pragma once

#include <Eigen/Core>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// To be raised with every change of what pictures look like, or of what it rests on (render_shape, principal_view,
/// colours): what a cache holds of earlier versions is then drawn anew.
inline constexpr int picture_version = 2;

/// How the models of a run are drawn for its report; alike for all of them.
struct PictureOptions {
  /// Values with the ends of the colour map, which runs with the square root of (value - low) so that thin parts differ
  /// as well; by default from 0 to the diameter of a sphere of unit area.
  Interval range = {.low = 0, .high = 0.5641895835477563};
  int width = 120;  ///< pixels
  int height = 96;  ///< pixels
};

/// A small picture of a shape in its principal_view(), coloured by the values of a field at the samples on it, as the
/// bytes of a PNG file with a transparent background. Depends on nothing else. Samples that are neither at all faces
/// nor at all vertices are drawn as a cloud of points. Throws as render_shape().
std::string model_picture(const Shape& shape, const Samples& samples, const Eigen::VectorXd& values,
                          const PictureOptions& options);

}  // namespace shapegauge
