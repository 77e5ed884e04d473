#include "shapegauge/retrieval/descriptors/panorama.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/retrieval/descriptors/cylinder_map.h"
#include "shapegauge/retrieval/descriptors/splats.h"
#include "shapegauge/retrieval/descriptors/surface_moments.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

constexpr std::array table = {
    option_of<&PanoramaOptions::angles>("angles", {.low = 64, .high = 1024}, "Cells around a cylinder."),
    option_of<&PanoramaOptions::heights>("heights", {.low = 64, .high = 1024}, "Cells along a cylinder."),
    option_of<&PanoramaOptions::frequencies>("frequencies", {.low = 1, .high = 31},
                                             "Highest Fourier frequency in either direction."),
    option_of<&PanoramaOptions::exponent>("exponent", {.low = 0.1, .high = 1}, "Exponent of the Fourier magnitudes."),
    option_of<&PanoramaOptions::sharpness>("sharpness", {.low = 0.1, .high = 16},
                                           "Exponent of the cosines between normals and lines of sight."),
    option_of<&PanoramaOptions::radius>(
        "radius", {.low = 0.1, .high = 100},
        "Radius of the cylinders, in root mean squares of the surface's distance from its centroid."),
};
constexpr auto parameters = parameters_of(table);

constexpr std::size_t poses = 2;

/// Returns waves (cos or sin) of frequency 0 to `highest`, one a row, at the centres of the cells.
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

/// Converts the shape to a mesh with its centroid at the origin and a root mean square distance of 1; also returns the
/// original moments.
std::pair<Shape, SurfaceMoments> centred_surface(const Shape& shape) {
  Shape mesh = splatted(shape);
  mesh = in_unit_frame(mesh, unit_frame(mesh));
  SurfaceMoments moments = surface_moments(mesh);
  const double spread = std::sqrt(moments.covariance.trace());
  if (!(spread > 0)) throw InputError("the descriptor panorama needs a shape with area");
  mesh.vertices = (mesh.vertices.rowwise() - moments.centroid.transpose()) / spread;
  return {std::move(mesh), moments};
}

}  // namespace

Eigen::VectorXf panorama(const Shape& shape, const PanoramaOptions& options) {
  check_options("panorama", table, options);
  const auto [centred, moments] = centred_surface(shape);
  const LowFrequencies transform(options);
  Eigen::VectorXf features(static_cast<Eigen::Index>(poses) * 3 * 2 * transform.features());
  Eigen::Index next = 0;
  const auto append = [&](const CylinderGrid& map) {
    features.segment(next, transform.features()) = transform(map);
    next += transform.features();
  };
  for (const Eigen::Matrix3d& of : {moments.covariance, moments.normals}) {
    const Shape posed{centred.vertices * principal_axes(of).transpose(), centred.triangles};
    for (const int axis : {0, 1, 2}) {
      check_interruption();
      const CylinderMap map = project_on_cylinder(
          posed, {.axis = axis, .radius = options.radius, .angles = options.angles, .heights = options.heights});
      append(map.distance);
      append(map.cosine.array().pow(static_cast<float>(options.sharpness)));
    }
  }
  return features;
}

double panorama_distance(std::span<const float> a, std::span<const float> b) {
  if (a.size() != b.size() || a.size() % poses != 0) {
    throw ArgumentError("panoramas of " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                        " features cannot be compared");
  }
  const std::size_t half = a.size() / poses;
  return std::min(l1_distance(a.first(half), b.first(half)), l1_distance(a.last(half), b.last(half)));
}

Descriptor panorama_descriptor() {
  return {.name = "panorama",
          .description = "Fourier magnitudes of the views from cylinders about principal axes (Papadakis et al. 2010).",
          .parameters = parameters,
          .version = panorama_version,
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                return panorama(input.shape, options_from(table, settings.values));
              },
          .distance = panorama_distance};
}

}  // namespace shapegauge
