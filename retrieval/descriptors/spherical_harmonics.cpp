// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/spherical_harmonics.h"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/legendre.hpp>
#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/spatial/triangle_bvh.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

constexpr std::array spherical_harmonics_table = {
    option_of<&SphericalHarmonicsOptions::shells>("shells", {.low = 1, .high = 256},
                                                  "Number of evenly spaced concentric spheres."),
    option_of<&SphericalHarmonicsOptions::bandwidth>(
        "bandwidth", {.low = 1, .high = 64},
        "Number of spherical harmonic degrees, from 0; more describe finer details."),
    with_unit("mean distances from the centroid",
              option_of<&SphericalHarmonicsOptions::width>(
                  "width", {.low = 0.001, .high = 10},
                  "Width w of the Gaussian exp(-(d / w)²) that represents the surface; d: distance to it.")),
    option_of<&SphericalHarmonicsOptions::voxels>(
        "voxels", "Represent the surface by voxels instead of the Gaussian; width is ignored."),
};
constexpr auto spherical_harmonics_parameters = parameters_of(spherical_harmonics_table);

/// Nodes and weights of Gauss-Legendre quadrature over [-1, 1].
struct Quadrature {
  Eigen::VectorXd nodes;
  Eigen::VectorXd weights;
};

Quadrature gauss_legendre(int count) {
  Quadrature result{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  const std::vector<double> not_negative = boost::math::legendre_p_zeros<double>(count);
  Eigen::Index i = 0;
  const auto add = [&](double node) {
    const double slope = boost::math::legendre_p_prime(count, node);
    result.nodes[i] = node;
    result.weights[i++] = 2 / ((1 - node * node) * slope * slope);
  };
  for (const double node : not_negative) {
    add(node);
    if (node > 0) add(-node);
  }
  return result;
}

Eigen::Index meridians_of(int bandwidth) { return 4 * static_cast<Eigen::Index>(bandwidth); }
Eigen::Index circles_of(int bandwidth) { return 2 * static_cast<Eigen::Index>(bandwidth); }

/// Scales the shape to a mean distance of 1 from its centroid, at the origin.
Shape centred(const Shape& shape, const Samples& samples) {
  const double total = samples.weights.sum();
  if (!(total > 0))
    throw InputError(
        "the descriptor spherical_harmonics needs a shape with area; check it for degenerate triangles or coincident "
        "points");
  const Eigen::RowVector3d centroid = samples.weights.transpose() * samples.points / total;
  const double mean = samples.weights.dot((samples.points.rowwise() - centroid).rowwise().norm()) / total;
  if (!(mean > 0))
    throw InputError("the descriptor spherical_harmonics needs a shape with extent; check it for coincident points");
  Shape result = without_duplicates(shape);
  result.vertices = (shape.vertices.rowwise() - centroid) / mean;
  result.normals = {};
  return result;
}

/// Cubes of a grid over [-2, 2]^3 that the surface intersects.
class Voxels {
 public:
  Voxels(const Shape& shape, int shells) : per_axis_(2 * static_cast<Eigen::Index>(shells)) {
    const Eigen::Index cubes = per_axis_ * per_axis_ * per_axis_;
    filled_.assign(static_cast<std::size_t>(cubes), 0);
    // About twenty samples for each cube of a sphere's surface.
    const Samples samples = sample_surface(shape, 60 * static_cast<Eigen::Index>(shells) * shells);
    for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
      const Eigen::Index cube = cube_of(samples.points.row(i));
      if (cube >= 0) filled_[static_cast<std::size_t>(cube)] = 1;
    }
  }

  [[nodiscard]] double at(const Eigen::RowVector3d& x) const {
    const Eigen::Index cube = cube_of(x);
    return cube >= 0 ? filled_[static_cast<std::size_t>(cube)] : 0;
  }

 private:
  [[nodiscard]] Eigen::Index cube_of(const Eigen::RowVector3d& x) const {
    Eigen::Index cube = 0;
    for (int k = 0; k < 3; ++k) {
      const double along = (x[k] + 2) / 4 * static_cast<double>(per_axis_);
      if (!(along >= 0 && along < static_cast<double>(per_axis_))) return -1;
      cube = cube * per_axis_ + static_cast<Eigen::Index>(along);
    }
    return cube;
  }

  Eigen::Index per_axis_;
  std::vector<char> filled_;
};

/// Computes the norms of a function of space on shells of radius 2 k / shells, shell by shell.
template <typename Function>
Eigen::VectorXf shell_norms(const SphericalHarmonicsOptions& options, Function at) {
  const HarmonicTransform transform(options.bandwidth);
  const Points& directions = transform.directions();
  Eigen::VectorXf features(options.shells * options.bandwidth);
  Eigen::VectorXd values(directions.rows());
  for (Eigen::Index shell = 0; shell < options.shells; ++shell) {
    check_interruption();
    const double radius = 2 * static_cast<double>(shell + 1) / options.shells;
    for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = at(radius * directions.row(i));
    features.segment(shell * options.bandwidth, options.bandwidth) = (radius * transform.norms(values)).cast<float>();
  }
  return features;
}

}  // namespace

HarmonicTransform::HarmonicTransform(int bandwidth) : directions_(circles_of(bandwidth) * meridians_of(bandwidth), 3) {
  const Eigen::Index meridians = meridians_of(bandwidth);
  const auto angle_of = [&](Eigen::Index step) {
    return 2 * std::numbers::pi * static_cast<double>(step) / static_cast<double>(meridians);
  };
  cosines_.resize(meridians, bandwidth);
  sines_.resize(meridians, bandwidth);
  for (Eigen::Index j = 0; j < meridians; ++j) {
    for (Eigen::Index m = 0; m < bandwidth; ++m) {
      const double angle = angle_of(j * m % meridians);
      cosines_(j, m) = std::cos(angle) * 2 * std::numbers::pi / static_cast<double>(meridians);
      sines_(j, m) = std::sin(angle) * 2 * std::numbers::pi / static_cast<double>(meridians);
    }
  }
  const Quadrature circles = gauss_legendre(static_cast<int>(circles_of(bandwidth)));
  for (int l = 0; l < bandwidth; ++l) {
    Eigen::MatrixXd of_order(circles.nodes.size(), l + 1);
    for (int m = 0; m <= l; ++m) {
      for (Eigen::Index i = 0; i < circles.nodes.size(); ++i) {
        const double polar = std::acos(circles.nodes[i]);
        of_order(i, m) = circles.weights[i] * boost::math::spherical_harmonic_r(l, m, polar, 0.0);
      }
    }
    by_frequency_.push_back(std::move(of_order));
  }
  for (Eigen::Index i = 0; i < circles.nodes.size(); ++i) {
    const double radius = std::sqrt(1 - circles.nodes[i] * circles.nodes[i]);
    for (Eigen::Index j = 0; j < meridians; ++j) {
      directions_.row(i * meridians + j) << radius * std::cos(angle_of(j)), radius * std::sin(angle_of(j)),
          circles.nodes[i];
    }
  }
}

Eigen::VectorXd HarmonicTransform::norms(const Eigen::VectorXd& values) const {
  if (values.size() != directions_.rows()) {
    throw ArgumentError("spherical harmonics need " + std::to_string(directions_.rows()) +
                        " values, one for each direction, not " + std::to_string(values.size()));
  }
  using Grid = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Grid> grid(values.data(), values.size() / cosines_.rows(), cosines_.rows());
  const Eigen::MatrixXd even = grid * cosines_;
  const Eigen::MatrixXd odd = grid * sines_;
  Eigen::VectorXd result(std::ssize(by_frequency_));
  for (Eigen::Index l = 0; l < result.size(); ++l) {
    const Eigen::MatrixXd& legendre = by_frequency_[static_cast<std::size_t>(l)];
    double square = 0;
    for (Eigen::Index m = 0; m <= l; ++m) {
      const double real = legendre.col(m).dot(even.col(m));
      const double imaginary = legendre.col(m).dot(odd.col(m));
      square += (m == 0 ? 1 : 2) * (real * real + imaginary * imaginary);  // -m has the same magnitude
    }
    result[l] = std::sqrt(square);
  }
  return result;
}

Eigen::VectorXf spherical_harmonics(const Shape& shape, const SphericalHarmonicsOptions& options) {
  check_options("spherical_harmonics", spherical_harmonics_table, options);
  constexpr Eigen::Index sample_count = 20'000;  // for the centroid and the mean distance to about 1 %
  const Samples samples = sample_surface(shape, sample_count);
  const Shape unit = centred(shape, samples);
  if (options.voxels) {
    const Voxels voxels(unit, options.shells);
    return shell_norms(options, [&](const Eigen::RowVector3d& x) { return voxels.at(x); });
  }
  const TriangleBVH tree(unit);
  const double reach = 4 * options.width;
  std::int32_t hint = -1;
  return shell_norms(options, [&](const Eigen::RowVector3d& x) {
    const auto hit = tree.closest(x.transpose(), reach, hint);
    if (!hit) return 0.0;
    hint = hit->triangle;
    return std::exp(-std::pow(hit->distance / options.width, 2));
  });
}

Descriptor spherical_harmonics_descriptor() {
  return {.name = "spherical_harmonics",
          .description = "Norms of spherical harmonics on concentric spheres (Kazhdan et al. 2003).",
          .parameters = spherical_harmonics_parameters,
          .version = 2,
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                return spherical_harmonics(input.shape, options_from(spherical_harmonics_table, settings.values));
              },
          .distance = l2_distance};
}

}  // namespace shapegauge
