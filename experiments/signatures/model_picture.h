// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/configuration/configuration.h"

namespace shapegauge {

/// Cache version of model_picture(), including render_shape(), upright_view() and colours; see docs/manual/cache.md.
inline constexpr int picture_version = 5;

/// Renders a small picture of a shape in its upright_view(), coloured by the values of a field at its samples, as PNG
/// bytes with a transparent background. The result depends only on the arguments. Samples other than all faces or all
/// vertices are drawn as a point cloud. Throws as render_shape() does.
std::string model_picture(const Shape& shape, const Samples& samples, const Eigen::VectorXd& values,
                          const PictureOptions& options, const Eigen::Vector3d& up);

}  // namespace shapegauge
