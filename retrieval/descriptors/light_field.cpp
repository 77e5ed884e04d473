// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/light_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/descriptors/silhouette.h"
#include "shapegauge/retrieval/descriptors/surface_mesh.h"
#include "shapegauge/retrieval/descriptors/surface_moments.h"

namespace shapegauge {

namespace {

constexpr std::array light_field_table = {
    with_unit("pixels", option_of<&LightFieldOptions::pixels>("pixels", {.low = 16, .high = 1024},
                                                              "Width and height of each silhouette.")),
};
constexpr auto light_field_parameters = parameters_of(light_field_table);

constexpr std::size_t light_field_sets = 10;
constexpr std::size_t light_field_views = 10;
constexpr std::size_t light_field_features = light_field_sets * light_field_views * silhouette_feature_count;
constexpr std::size_t view_size = 48;  // the features and zeros after them: whole vectors are faster to compare
static_assert(view_size >= silhouette_feature_count);

using Axes = std::array<Eigen::Vector3d, light_field_views>;
using ViewPermutation = std::array<std::uint8_t, light_field_views>;
constexpr std::size_t rotations_of_dodecahedron = 60;

/// Returns one of each pair of opposite vertices of a dodecahedron.
Axes dodecahedron_axes() {
  const double golden = std::numbers::phi;
  Axes axes = {{{1, 1, 1},
                {1, 1, -1},
                {1, -1, 1},
                {-1, 1, 1},
                {0, 1 / golden, golden},
                {0, 1 / golden, -golden},
                {1 / golden, golden, 0},
                {1 / golden, -golden, 0},
                {golden, 0, 1 / golden},
                {golden, 0, -1 / golden}}};
  for (Eigen::Vector3d& axis : axes) axis.normalize();
  return axes;
}

/// Returns the rotations that map a dodecahedron to itself, as those that map two adjacent vertices to adjacent
/// vertices.
std::vector<Eigen::Matrix3d> dodecahedron_rotations() {
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& axis : dodecahedron_axes()) vertices.insert(vertices.end(), {axis, -axis});
  const double neighbours = std::sqrt(5.0) / 3;  // the cosine between two that share an edge
  const auto frame = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    Eigen::Matrix3d axes;
    const Eigen::Vector3d normal = a.cross(b).normalized();
    axes << a, normal, a.cross(normal);
    return axes;
  };
  std::vector<Eigen::Matrix3d> rotations;
  Eigen::Matrix3d first = Eigen::Matrix3d::Identity();
  for (const Eigen::Vector3d& a : vertices) {
    for (const Eigen::Vector3d& b : vertices) {
      if (std::abs(a.dot(b) - neighbours) > 1e-6) continue;
      if (rotations.empty()) first = frame(a, b);
      rotations.emplace_back(frame(a, b) * first.transpose());
    }
  }
  return rotations;
}

/// Returns, by rotation of the dodecahedron, the axis to which each axis is mapped.
std::array<ViewPermutation, rotations_of_dodecahedron> view_permutations() {
  const Axes axes = dodecahedron_axes();
  std::array<ViewPermutation, rotations_of_dodecahedron> permutations{};
  std::size_t r = 0;
  for (const Eigen::Matrix3d& rotation : dodecahedron_rotations()) {
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const auto upon = std::ranges::max_element(
          axes, {}, [&](const Eigen::Vector3d& axis) { return std::abs(axis.dot(rotation * axes[k])); });
      permutations[r][k] = static_cast<std::uint8_t>(upon - axes.begin());
    }
    ++r;
  }
  return permutations;
}

/// Returns the rotations of the sets. The first is the identity. Each further one is the random candidate farthest from
/// the previous ones, modulo rotations of the dodecahedron.
std::array<Eigen::Quaterniond, light_field_sets> set_turns() {
  std::vector<Eigen::Quaterniond> symmetries;
  for (const Eigen::Matrix3d& rotation : dodecahedron_rotations()) symmetries.emplace_back(rotation);
  RandomNumbers random(1);
  std::vector<Eigen::Quaterniond> candidates;
  constexpr std::size_t enough = 2000;
  while (candidates.size() < enough) {
    Eigen::Quaterniond turn;
    for (double& coefficient : turn.coeffs()) coefficient = random.uniform(-1, 1);
    const double norm = turn.norm();
    if (norm > 0.1 && norm <= 1) candidates.push_back(turn.normalized());  // a ball in four dimensions is even
  }
  std::array<Eigen::Quaterniond, light_field_sets> turns;
  turns.front() = Eigen::Quaterniond::Identity();
  std::vector<double> nearest(candidates.size(), 0);  // the cosine of half the angle to the nearest of those there are
  for (std::size_t count = 1; count < turns.size(); ++count) {
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      for (const Eigen::Quaterniond& symmetry : symmetries) {
        const double cosine = std::abs((turns[count - 1] * symmetry).dot(candidates[c]));
        nearest[c] = std::max(nearest[c], cosine);
      }
    }
    turns[count] = candidates[static_cast<std::size_t>(std::ranges::min_element(nearest) - nearest.begin())];
  }
  return turns;
}

/// Mesh for drawing: the used vertices, one a column.
struct DrawnMesh {
  Eigen::Matrix3Xf vertices;
  Triangles triangles;
};

/// Converts the shape to a mesh with its centroid at the origin and the unit ball as bounding ball.
DrawnMesh in_unit_ball(const Shape& shape) {
  Shape mesh = surface_mesh(shape);
  mesh = in_unit_frame(mesh, unit_frame(mesh));
  const SurfaceMoments moments = surface_moments(mesh);
  if (!(moments.area > 0))
    throw InputError(
        "the descriptor light_field needs a shape with area; check it for degenerate triangles or coincident points");
  const std::vector<bool> used = used_vertices(mesh);
  std::vector<std::int32_t> drawn(used.size(), -1);
  DrawnMesh result{{}, std::move(mesh.triangles)};
  Eigen::Matrix3Xd centred = mesh.vertices.transpose().colwise() - moments.centroid;
  std::int32_t count = 0;
  double square = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    centred.col(count) = centred.col(static_cast<Eigen::Index>(v)).eval();
    square = std::max(square, centred.col(count).squaredNorm());
    drawn[v] = count++;
  }
  result.vertices = (centred.leftCols(count) / std::sqrt(square)).cast<float>();
  for (std::int32_t& vertex : std::span(result.triangles.data(), static_cast<std::size_t>(result.triangles.size()))) {
    vertex = drawn[static_cast<std::size_t>(vertex)];
  }
  return result;
}

using Bytes = std::array<std::uint8_t, light_field_sets * light_field_views * view_size>;

Bytes bytes_of(std::span<const float> features) {
  if (features.size() != light_field_features) {
    throw ArgumentError("a light field has " + std::to_string(light_field_features) + " features, not " +
                        std::to_string(features.size()));
  }
  // Plain loops over all features, which compilers vectorise.
  std::array<std::uint8_t, light_field_features> together{};
  unsigned outside = 0;
  for (std::size_t k = 0; k < light_field_features; ++k) {
    outside |= static_cast<unsigned>(!(features[k] >= 0)) | static_cast<unsigned>(!(features[k] <= 255));
  }
  if (outside != 0) throw ArgumentError("the features of a light field must be from 0 to 255");
  for (std::size_t k = 0; k < light_field_features; ++k) {
    together[k] = static_cast<std::uint8_t>(static_cast<int>(features[k]));
  }
  Bytes bytes{};
  for (std::size_t view = 0; view < light_field_sets * light_field_views; ++view) {
    std::copy_n(&together[view * silhouette_feature_count], silhouette_feature_count, &bytes[view * view_size]);
  }
  return bytes;
}

std::uint32_t l1_of_views(const std::uint8_t* a, const std::uint8_t* b) {
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < view_size; ++k) {
    sum += static_cast<std::uint32_t>(std::abs(static_cast<int>(a[k]) - static_cast<int>(b[k])));
  }
  return sum;
}

}  // namespace

Eigen::VectorXf light_field(const Shape& shape, const LightFieldOptions& options) {
  check_options("light_field", light_field_table, options);
  const DrawnMesh mesh = in_unit_ball(shape);
  static const std::array<Eigen::Quaterniond, light_field_sets> turns = set_turns();
  const Axes axes = dodecahedron_axes();
  const std::shared_ptr<const SilhouetteFeatures> features_of = shared_silhouette_features(options.pixels);
  Eigen::VectorXf features(light_field_features);
  Eigen::Index next = 0;
  for (const Eigen::Quaterniond& turn : turns) {
    for (const Eigen::Vector3d& axis : axes) {
      check_interruption();
      const Eigen::Matrix3d rotation = rotation_between(turn * axis, Eigen::Vector3d::UnitZ());
      for (const double feature : (*features_of)(silhouette(mesh.vertices, mesh.triangles, rotation, options.pixels))) {
        features[next++] = static_cast<float>(std::round(255 * std::min(feature, 1.0)));
      }
    }
  }
  return features;
}

double light_field_distance(std::span<const float> a, std::span<const float> b) {
  static const std::array<ViewPermutation, rotations_of_dodecahedron> permutations = view_permutations();
  const Bytes bytes_a = bytes_of(a);
  const Bytes bytes_b = bytes_of(b);
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  std::array<std::array<std::uint32_t, light_field_views>, light_field_views> between{};
  constexpr std::size_t set_size = light_field_views * view_size;
  for (std::size_t s = 0; s < light_field_sets; ++s) {
    for (std::size_t t = 0; t < light_field_sets; ++t) {
      for (std::size_t i = 0; i < light_field_views; ++i) {
        for (std::size_t j = 0; j < light_field_views; ++j) {
          between[i][j] = l1_of_views(&bytes_a[s * set_size + i * view_size], &bytes_b[t * set_size + j * view_size]);
        }
      }
      for (const ViewPermutation& permutation : permutations) {
        std::uint32_t sum = 0;
        for (std::size_t i = 0; i < light_field_views; ++i) sum += between[i][permutation[i]];
        least = std::min(least, sum);
      }
    }
  }
  return least / 255.0;
}

Descriptor light_field_descriptor() {
  return {.name = "light_field",
          .description = "Zernike moments and Fourier coefficients of silhouettes from all sides (Chen et al. 2003).",
          .parameters = light_field_parameters,
          .version = 3,
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                return light_field(input.shape, options_from(light_field_table, settings.values));
              },
          .distance = light_field_distance};
}

}  // namespace shapegauge
