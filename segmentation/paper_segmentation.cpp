// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/paper_segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/segmentation/alpha_expansion.h"
#include "shapegauge/segmentation/gaussian_mixture.h"
#include "shapegauge/segmentation/patch_features.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "shapegauge/segmentation/sound_mesh.h"

namespace shapegauge {

namespace {

constexpr int quantile_levels = 16;  ///< quantiles of each field's distribution on a patch
constexpr double min_probability = 1e-6;
constexpr double min_turn = 1e-3;  ///< radians, so that flat borders cost a finite amount
constexpr double convex_share = 0.1;

/// Returns the cost per length of a border: small where the surface is folded.
double cost_of_turn(double concavity) {
  const double turn = std::max(min_turn, concavity > 0 ? concavity : -convex_share * concavity);
  return -std::log(turn / std::numbers::pi);
}

std::vector<LabelEdge> borders_of(const SurfaceGraph& graph, const std::vector<std::int32_t>& patch,
                                  double smoothness) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> costs;
  double lengths = 0;
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    for (const SurfaceLink& link : graph.links_of(i)) {
      const std::int32_t a = patch[static_cast<std::size_t>(i)];
      const std::int32_t b = patch[static_cast<std::size_t>(link.to)];
      if (a >= b) continue;
      costs[{a, b}] += link.length * cost_of_turn(link.concavity);
      lengths += link.length;
    }
  }
  std::vector<LabelEdge> borders;
  borders.reserve(costs.size());
  const double mean_length = costs.empty() ? 1 : lengths / static_cast<double>(costs.size());
  for (const auto& [patches, cost] : costs) {
    borders.push_back({patches.first, patches.second, mean_length > 0 ? smoothness * cost / mean_length : 0});
  }
  return borders;
}

}  // namespace

std::vector<std::int32_t> paper_segmentation(const SurfaceGraph& graph, std::span<const ScalarField> fields,
                                             const PaperSegmentationOptions& options) {
  if (!(options.smoothness >= 0 && std::isfinite(options.smoothness))) {
    throw InputError(fmt::format("the smoothness must be at least 0, not {}", options.smoothness));
  }
  const std::vector<std::int32_t> patch = patches(graph, options.patches);
  const Eigen::MatrixXd features = patch_features(patch, fields, quantile_levels);
  const GaussianMixture mixture = fit_gaussian_mixture(features, options.clusters);
  const Eigen::MatrixXd costs = -component_probabilities(mixture, features).array().max(min_probability).log();
  std::vector<std::int32_t> start;
  for (Eigen::Index p = 0; p < costs.rows(); ++p) {
    Eigen::Index cheapest = 0;
    costs.row(p).minCoeff(&cheapest);
    start.push_back(static_cast<std::int32_t>(cheapest));
  }
  const std::vector<std::int32_t> clusters =
      alpha_expansion(costs, borders_of(graph, patch, options.smoothness), std::move(start));
  std::vector<std::int32_t> labels;
  labels.reserve(patch.size());
  for (const std::int32_t p : patch) labels.push_back(clusters[static_cast<std::size_t>(p)]);
  return renumber_labels(
      without_slivers(graph, connected_parts(graph, labels), min_patch_fraction / options.patches.count));
}

std::vector<std::int32_t> paper_segmentation(const Shape& shape, std::optional<double> offset,
                                             const PaperSegmentationOptions& options, OffsetSdfOutcomes* outcomes) {
  const SoundMesh mesh = sound_mesh(shape);
  const SurfaceGraph graph = surface_graph(mesh.shape);
  ScalarField field{.values = {}, .weights = graph.samples.weights};
  if (offset) {
    OffsetSdfResult result = offset_sdf(mesh.shape, graph.samples, {.offset = *offset});
    field.values = std::move(result.values);
    if (outcomes != nullptr) *outcomes = result.outcomes;
  } else {
    field.values = cone_sdf(mesh.shape, graph.samples, {}).values;
  }
  return mesh.extended(paper_segmentation(graph, {&field, 1}, options));
}

}  // namespace shapegauge
