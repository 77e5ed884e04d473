// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of views; see docs/manual/cache.md.
inline constexpr int model_view_version = 3;

/// Maximum number of models with views in a report.
inline constexpr std::size_t max_models_with_views = 2000;

/// Limits of the faces of the views on a page. The defaults limit the size of a report to a few megabytes.
struct ViewFaces {
  Eigen::Index in_total = 240'000;
  Eigen::Index fewest = 200;  ///< lower limit for one view
  Eigen::Index most = 3000;   ///< upper limit for one view
};

/// Returns the number of faces of a view, which decreases with the number of models on its page.
Eigen::Index faces_of_views(std::size_t models, const ViewFaces& limits = {});

/// How a shape is drawn.
struct ShapeDrawing {
  Eigen::Index faces = 0;          ///< maximum number in its view; 0: without a view
  Eigen::Vector3d up = {0, 0, 1};  ///< vertical direction
};

/// Values of a field at samples of a shape.
struct SampledField {
  const Samples& samples;
  const Eigen::VectorXd& values;
};

/// Encodes a shape simplified to at most `drawing.faces` faces, or points, with the fields at its vertices, as JSON
/// (shape_view_json()) without names. Depends on nothing else. Throws as coarse_shape() and shape_view_json() do.
std::string model_view(const Shape& shape, std::span<const SampledField> fields, const ShapeDrawing& drawing);

}  // namespace shapegauge
