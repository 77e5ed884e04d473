#pragma once

#include <Eigen/Core>

#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// Independent normal coordinates of mean 0 and standard deviation 1 (Box and Muller 1958).
Eigen::Vector3d gaussian_vector(RandomNumbers& random);

/// Uniform in the ball of radius 1 about the origin.
Eigen::Vector3d point_in_unit_ball(RandomNumbers& random);

/// Uniform over all rotations (Shoemake 1992).
Eigen::Matrix3d uniform_rotation(RandomNumbers& random);

}  // namespace shapegauge
