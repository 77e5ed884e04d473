#include "shapegauge/core/perturbation/random_motion.h"

#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/random_vectors.h"
#include "shapegauge/core/perturbation/required_extent.h"

namespace shapegauge {

Shape random_motion(Shape shape, double scale, RandomNumbers& random) {
  if (!(scale >= 1 && std::isfinite(scale))) {
    throw InputError(fmt::format("the largest scale of a motion must be a number of at least 1, not {}", scale));
  }
  const Eigen::RowVector3d shift = required_diagonal(shape) * point_in_unit_ball(random).transpose();
  const Eigen::Matrix3d rotation = uniform_rotation(random);
  const double factor = std::exp(std::log(scale) * random.uniform(-1, 1));
  const Eigen::RowVector3d centre = bounding_box(shape).center().transpose();
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    const Eigen::RowVector3d turned = factor * (shape.vertices.row(i) - centre) * rotation.transpose();
    shape.vertices.row(i) = turned + centre + shift;
  }
  for (Eigen::Index i = 0; i < shape.normals.rows(); ++i) {
    const Eigen::RowVector3d turned = shape.normals.row(i) * rotation.transpose();
    shape.normals.row(i) = turned;
  }
  return shape;
}

}  // namespace shapegauge
