// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of interactive views (model_view()); see docs/manual/cache.md.
inline constexpr int model_view_version = 3;

/// Maximum number of models with views in a report.
inline constexpr std::size_t max_models_with_views = 2000;

/// Limits of the number of faces in the interactive views on a page. The defaults limit the size of a report to a few
/// megabytes.
struct ViewFaces {
  Eigen::Index max_total = 240'000;  ///< maximum number of faces of all views on the page together
  Eigen::Index fewest = 200;         ///< lower bound of the limit of faces per view, even if max_total is exceeded
  Eigen::Index most = 3000;          ///< upper bound of the limit of faces per view
};

/// Returns the maximum number of faces of an interactive view, which decreases with the number of models on its page.
Eigen::Index faces_of_views(std::size_t models, const ViewFaces& limits = {});

/// Settings of the picture and the interactive view of a shape.
struct ShapeDrawing {
  Eigen::Index faces = 0;          ///< maximum number of faces in the interactive view; 0 for no view
  Eigen::Vector3d up = {0, 0, 1};  ///< vertical direction in pictures and views
};

/// Values of a field at samples of a shape.
struct SampledField {
  const Samples& samples;         ///< samples of the shape; not owned
  const Eigen::VectorXd& values;  ///< one value per sample; NaN if missing
};

/// Encodes a shape simplified to at most `drawing.faces` faces, or points, with the fields at its vertices, as JSON
/// (shape_view_json()) without names. The result depends only on the arguments. Throws as coarse_shape() and
/// shape_view_json() do.
std::string model_view(const Shape& shape, std::span<const SampledField> fields, const ShapeDrawing& drawing);

}  // namespace shapegauge
