// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/panorama.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/retrieval/descriptors/cylinder_map.h"
#include "shapegauge/retrieval/descriptors/surface_mesh.h"
#include "shapegauge/retrieval/descriptors/surface_moments.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

constexpr std::array panorama_table = {
    option_of<&PanoramaOptions::angles>("angles", {.low = 64, .high = 1024},
                                        "Number of cells around the axis of each cylinder; a multiple of 64."),
    option_of<&PanoramaOptions::heights>("heights", {.low = 64, .high = 1024},
                                         "Number of cells along the axis of each cylinder; a multiple of 64."),
    option_of<&PanoramaOptions::frequencies>("frequencies", {.low = 1, .high = 31},
                                             "Highest Fourier frequency around and along the cylinder axis."),
    option_of<&PanoramaOptions::exponent>(
        "exponent", {.low = 0.1, .high = 1},
        "Exponent of the Fourier magnitudes; smaller values give weak frequencies more weight."),
    option_of<&PanoramaOptions::sharpness>(
        "sharpness", {.low = 0.1, .high = 16},
        "Exponent of the cosine between normal and line of sight; larger values weaken oblique surfaces."),
    with_unit("RMS distances from the centroid",
              option_of<&PanoramaOptions::radius>("radius", {.low = 0.1, .high = 100},
                                                  "Radius of the cylinders; surfaces outside are ignored.")),
};
constexpr auto panorama_parameters = parameters_of(panorama_table);

constexpr std::size_t poses = 2;
constexpr std::size_t maps = 6;  // maps of a pose: distances and cosines for each axis

constexpr int wavelet_levels = 6;
constexpr std::size_t subband_features = 3;  // mean, standard deviation, skewness
constexpr std::size_t wavelet_features = (3 * wavelet_levels + 1) * subband_features;  // per map

/// Returns waves (cos or sin) of frequency 0 to `highest`, one per row, at the centres of the cells.
Eigen::MatrixXf waves(int highest, int cells, double (*wave)(double)) {
  Eigen::MatrixXf result(highest + 1, cells);
  for (int k = 0; k <= highest; ++k) {
    for (int i = 0; i < cells; ++i) {
      result(k, i) = static_cast<float>(wave(2 * std::numbers::pi * (i + 0.5) * k / cells));
    }
  }
  return result;
}

/// Features of maps of one size: Fourier magnitudes at low frequencies.
class LowFrequencies {
 public:
  explicit LowFrequencies(const PanoramaOptions& options)
      : exponent_(static_cast<float>(options.exponent)),
        around_cos_(waves(options.frequencies, options.angles, std::cos)),
        around_sin_(waves(options.frequencies, options.angles, std::sin)),
        along_cos_(waves(options.frequencies, options.heights, std::cos)),
        along_sin_(waves(options.frequencies, options.heights, std::sin)) {}

  [[nodiscard]] Eigen::Index features() const { return 2 * around_cos_.rows() * along_cos_.rows(); }

  [[nodiscard]] Eigen::VectorXf operator()(const CylinderGrid& map) const {
    const Eigen::MatrixXf even = map * around_cos_.transpose();
    const Eigen::MatrixXf odd = map * around_sin_.transpose();
    const Eigen::ArrayXXf even_cos = along_cos_ * even;
    const Eigen::ArrayXXf even_sin = along_sin_ * even;
    const Eigen::ArrayXXf odd_cos = along_cos_ * odd;
    const Eigen::ArrayXXf odd_sin = along_sin_ * odd;
    const Eigen::ArrayXXf one = ((even_cos - odd_sin).square() + (even_sin + odd_cos).square()).sqrt();
    const Eigen::ArrayXXf other = ((even_cos + odd_sin).square() + (even_sin - odd_cos).square()).sqrt();
    const float sum = one.sum() + other.sum();
    Eigen::VectorXf result(features());
    result << one.max(other).reshaped(), one.min(other).reshaped();
    if (sum > 0) result = (result.array() / sum).pow(exponent_);
    return result;
  }

 private:
  float exponent_;
  Eigen::MatrixXf around_cos_;
  Eigen::MatrixXf around_sin_;
  Eigen::MatrixXf along_cos_;
  Eigen::MatrixXf along_sin_;
};

/// Computes the mean, standard deviation and skewness of the absolute values.
Eigen::Vector3f statistics(const CylinderGrid& coefficients) {
  const Eigen::ArrayXXd sizes = coefficients.array().abs().cast<double>();
  const double mean = sizes.mean();
  const double deviation = std::sqrt((sizes - mean).square().mean());
  constexpr double negligible = 1e-6;  // relative to the largest coefficients, which are of the order of 1
  const double skewness = deviation > negligible ? (sizes - mean).cube().mean() / std::pow(deviation, 3) : 0;
  return Eigen::Vector3d(mean, deviation, skewness).cast<float>();
}

/// Computes the statistics of each subband of a map's Haar wavelet transform: from the finest level on, the details
/// around the axis, along it and in both directions, followed by the coarsest approximation.
Eigen::VectorXf haar_statistics(CylinderGrid map) {
  Eigen::VectorXf result(static_cast<Eigen::Index>(wavelet_features));
  Eigen::Index next = 0;
  const auto append = [&](const CylinderGrid& subband) {
    result.segment<subband_features>(next) = statistics(subband);
    next += subband_features;
  };
  for (int level = 0; level < wavelet_levels; ++level) {
    const auto rows = [&](Eigen::Index first) { return Eigen::seqN(first, map.rows() / 2, 2); };
    const auto columns = [&](Eigen::Index first) { return Eigen::seqN(first, map.cols() / 2, 2); };
    const CylinderGrid sums = map(Eigen::all, columns(0)) + map(Eigen::all, columns(1));
    const CylinderGrid differences = map(Eigen::all, columns(0)) - map(Eigen::all, columns(1));
    append((differences(rows(0), Eigen::all) + differences(rows(1), Eigen::all)) / 2);
    append((sums(rows(0), Eigen::all) - sums(rows(1), Eigen::all)) / 2);
    append((differences(rows(0), Eigen::all) - differences(rows(1), Eigen::all)) / 2);
    map = ((sums(rows(0), Eigen::all) + sums(rows(1), Eigen::all)) / 2).eval();
  }
  append(map);
  return result;
}

/// Computes the mean of |x - y| / (|x| + |y|), where 0 / 0 counts as 0.
double mean_canberra_distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = std::abs(static_cast<double>(a[i])) + std::abs(static_cast<double>(b[i]));
    if (size > 0) sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) / size;
  }
  return sum / static_cast<double>(a.size());
}

/// Computes the distance in one pose.
double pose_distance(std::span<const float> a, std::span<const float> b) {
  constexpr double wavelet_weight = 20;
  const std::size_t fourier = a.size() - maps * wavelet_features;
  return l1_distance(a.first(fourier), b.first(fourier)) +
         wavelet_weight * mean_canberra_distance(a.subspan(fourier), b.subspan(fourier));
}

/// Converts the shape to a mesh with its centroid at the origin and a root mean square distance of 1; also returns the
/// original moments.
std::pair<Shape, SurfaceMoments> centred_surface(const Shape& shape) {
  Shape mesh = surface_mesh(shape);
  mesh = in_unit_frame(mesh, unit_frame(mesh));
  SurfaceMoments moments = surface_moments(mesh);
  const double spread = std::sqrt(moments.covariance.trace());
  if (!(spread > 0))
    throw InputError(
        "the descriptor panorama needs a shape with area; check it for degenerate triangles or coincident points");
  mesh.vertices = (mesh.vertices.rowwise() - moments.centroid.transpose()) / spread;
  return {std::move(mesh), moments};
}

/// Returns the rotations into the poses. A flat shape is seen from its edges only; it is tilted about its longest axis,
/// in both poses, since its normals determine no axes.
std::array<Eigen::Matrix3d, poses> rotations_into_poses(const SurfaceMoments& moments) {
  const Eigen::Matrix3d axes = principal_axes(moments.covariance);
  const double thickness = axes.row(2) * moments.covariance * axes.row(2).transpose();
  constexpr double flat = 1e-12;  // of the variance: a millionth of its extent
  if (thickness > flat * moments.covariance.trace()) return {axes, principal_axes(moments.normals)};
  const Eigen::Matrix3d tilted = Eigen::AngleAxisd(std::numbers::pi / 4, Eigen::Vector3d::UnitX()) * axes;
  return {tilted, tilted};
}

}  // namespace

Eigen::VectorXf panorama(const Shape& shape, const PanoramaOptions& options) {
  check_options("panorama", panorama_table, options);
  constexpr int coarsest = 1 << wavelet_levels;
  if (options.angles % coarsest != 0 || options.heights % coarsest != 0) {
    throw InputError("the descriptor panorama needs angles and heights that are multiples of 64, not " +
                     std::to_string(options.angles) + " and " + std::to_string(options.heights));
  }
  const auto [centred, moments] = centred_surface(shape);
  const LowFrequencies transform(options);
  const auto in_wavelets = static_cast<Eigen::Index>(wavelet_features);
  const Eigen::Index of_pose = static_cast<Eigen::Index>(maps) * (transform.features() + in_wavelets);
  Eigen::VectorXf features(static_cast<Eigen::Index>(poses) * of_pose);
  Eigen::Index next = 0;
  for (const Eigen::Matrix3d& rotation : rotations_into_poses(moments)) {
    const Shape posed{centred.vertices * rotation.transpose(), centred.triangles};
    Eigen::Index next_wavelets = next + static_cast<Eigen::Index>(maps) * transform.features();
    const auto append = [&](const CylinderGrid& map) {
      features.segment(next, transform.features()) = transform(map);
      features.segment(next_wavelets, in_wavelets) = haar_statistics(map);
      next += transform.features();
      next_wavelets += in_wavelets;
    };
    for (const int axis : {0, 1, 2}) {
      check_interruption();
      const CylinderMap map = project_on_cylinder(
          posed, {.axis = axis, .radius = options.radius, .angles = options.angles, .heights = options.heights});
      append(map.distance);
      append(map.cosine.array().pow(static_cast<float>(options.sharpness)));
    }
    next = next_wavelets;
  }
  return features;
}

double panorama_distance(std::span<const float> a, std::span<const float> b) {
  if (a.size() != b.size() || a.size() % poses != 0 || a.size() < poses * maps * wavelet_features) {
    throw ArgumentError("panoramas of " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                        " features cannot be compared");
  }
  const std::size_t half = a.size() / poses;
  return std::min(pose_distance(a.first(half), b.first(half)), pose_distance(a.last(half), b.last(half)));
}

Descriptor panorama_descriptor() {
  return {
      .name = "panorama",
      .description =
          "Fourier magnitudes and wavelet statistics of projections on cylinders about principal axes (Papadakis et "
          "al. 2010).",
      .parameters = panorama_parameters,
      .version = 3,
      .describe =
          [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
            return panorama(input.shape, options_from(panorama_table, settings.values));
          },
      .distance = panorama_distance};
}

}  // namespace shapegauge
