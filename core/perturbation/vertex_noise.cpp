#include "shapegauge/core/perturbation/vertex_noise.h"

#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/random_vectors.h"
#include "shapegauge/core/perturbation/required_extent.h"

namespace shapegauge {

Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random) {
  if (!(options.amplitude >= 0 && std::isfinite(options.amplitude))) {
    throw InputError(fmt::format("the amplitude of noise must be a number of at least 0, not {}", options.amplitude));
  }
  const double length = options.amplitude * required_diagonal(shape);
  const bool gaussian = options.distribution == NoiseDistribution::gaussian;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    const Eigen::Vector3d displacement = gaussian ? gaussian_vector(random) : point_in_unit_ball(random);
    shape.vertices.row(i) += length * displacement.transpose();
  }
  return shape;
}

}  // namespace shapegauge
