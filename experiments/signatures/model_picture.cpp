// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/model_picture.h"

#include <algorithm>
#include <cmath>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"

namespace shapegauge {

namespace {

/// Encodes the image as PNG with 64 levels a channel and 16 of opacity, which looks the same at this size and takes a
/// third less.
std::string encode_small(Image image) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const int step = i % 4 == 3 ? 17 : 4;
    image.pixels[i] = static_cast<std::uint8_t>(std::min(255, (image.pixels[i] + step / 2) / step * step));
  }
  return encode_png(image);
}

}  // namespace

std::string model_picture(const Shape& shape, const Samples& samples, const Eigen::VectorXd& values,
                          const PictureOptions& options, const Eigen::Vector3d& up) {
  const double width = options.range.high - options.range.low;
  // Below the range the root would be NaN, which represents a missing value.
  const auto colour_position = [&](double value) {
    const double part = (value - options.range.low) / width;
    return part < 0 ? 0 : std::sqrt(part);
  };
  const Eigen::VectorXd positions = values.unaryExpr(colour_position);
  const std::vector<Colour> colours = colours_of(positions, 0, 1);
  const RenderOptions view{
      .width = options.width, .height = options.height, .up = up, .rays_per_side = 2, .transparent = true};
  // The samples of a cloud may also be a subset of its points.
  const bool are_some_points = is_cloud(shape) && samples.points.rows() != shape.vertices.rows();
  if (samples.site == SampleSite::surface || are_some_points) {
    const Shape cloud{.vertices = samples.points, .triangles = {}, .normals = samples.normals};
    return encode_small(render_shape(cloud, colours, SampleSite::vertices, upright_view(cloud, view)));
  }
  return encode_small(render_shape(shape, colours, samples.site, upright_view(shape, view)));
}

}  // namespace shapegauge
