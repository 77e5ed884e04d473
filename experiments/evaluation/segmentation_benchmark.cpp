// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>
#include <string_view>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/datasets/layouts/layouts.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Classes of the numbers 1 to 20, 21 to 40 and so on. The benchmark's tables omit the springs.
constexpr std::array<std::string_view, 21> psb_classes = {
    "human", "cup",  "glasses", "airplane",  "ant",  "chair", "octopus", "table", "teddy",   "hand", "plier",
    "fish",  "bird", "spring",  "armadillo", "bust", "mech",  "bearing", "vase",  "fourleg", "other"};
constexpr int models_per_class = 20;

std::size_t psb_class(const std::string& id) {
  int number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  const bool known = error == std::errc() && end == id.data() + id.size() && number >= 1 &&
                     number <= models_per_class * static_cast<int>(psb_classes.size() - 1);
  return known ? static_cast<std::size_t>((number - 1) / models_per_class) : psb_classes.size() - 1;
}

/// Returns the segmentations in a folder or, if it cannot be read, the folder itself, which then fails.
std::vector<fs::path> seg_files(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!is_folder(folder)) return is_broken_link(folder) ? std::vector{folder} : files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure)) {
    if (entry->path().extension() == ".seg") files.push_back(entry->path());
  }
  if (failure) return {folder};
  std::ranges::sort(files);
  return files;
}

/// Averages each error over its defined values.
SegmentationErrors mean_of(const std::vector<SegmentationErrors>& all) {
  SegmentationErrors mean;
  for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
    double sum = 0;
    int count = 0;
    for (const SegmentationErrors& errors : all) {
      if (std::isnan(errors.*entry.value)) continue;
      sum += errors.*entry.value;
      ++count;
    }
    mean.*entry.value = count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
  }
  return mean;
}

std::vector<MeshEdge> edges_of(const Shape& mesh, const std::vector<std::int32_t>& merged) {
  std::vector<MeshEdge> edges;
  for_each_edge(half_edges(mesh.triangles, merged), [&](std::span<const HalfEdge> uses) {
    MeshEdge edge;
    edge.vertices = {uses[0].low, uses[0].high};
    edge.triangles = {uses[0].triangle, uses.size() > 1 ? uses[1].triangle : -1};
    edge.length = (mesh.vertices.row(uses[0].high) - mesh.vertices.row(uses[0].low)).norm();
    edges.push_back(edge);
  });
  return edges;
}

}  // namespace

SegmentationBenchmark find_segmentation_benchmark(const fs::path& root) {
  for (const char* folder : {"off", "seg"}) {
    if (is_folder(root / folder)) continue;
    throw InputError(fmt::format(
        "{}: no folder {}; a segmentation benchmark has meshes off/N.off and human segmentations seg/N/*.seg",
        root.string(), folder));
  }
  SegmentationBenchmark benchmark;
  std::array<int, psb_classes.size()> labels = {};
  labels.fill(-1);
  for (const fs::path& mesh : model_files(root / "off")) {
    SegmentedModel model{.id = mesh.stem().string(), .mesh = mesh, .people = seg_files(root / "seg" / mesh.stem())};
    if (model.people.empty()) {
      benchmark.without_people.push_back(model.id);
      continue;
    }
    const std::size_t name = psb_class(model.id);
    if (labels[name] < 0) {
      labels[name] = static_cast<int>(benchmark.classes.size());
      benchmark.classes.emplace_back(psb_classes[name]);
    }
    model.label = labels[name];
    benchmark.models.push_back(std::move(model));
  }
  if (benchmark.models.empty()) {
    throw InputError(fmt::format("{}: no mesh off/N.off has a segmentation seg/N/*.seg", root.string()));
  }
  return benchmark;
}

SegmentationBenchmark find_generated_parts(const fs::path& root) {
  const Dataset dataset = find_dataset(recognise_dataset(root));
  SegmentationBenchmark shapes{.models = {}, .classes = dataset.classes, .without_people = {}};
  for (const Model& model : dataset.models) {
    fs::path parts = model.file;
    shapes.models.push_back(
        {.id = model.id, .mesh = model.file, .people = {parts.replace_extension(".seg")}, .label = model.label});
  }
  return shapes;
}

SegmentationScorer::SegmentationScorer(const Shape& mesh, const SegmentationScoring& scoring) {
  if (is_cloud(mesh))
    throw InputError("segmentations are compared by faces, and this shape is a point cloud; use a mesh");
  const Samples samples = sample_shape(mesh, SampleSite::faces);
  if (scoring.by == TriangleWeights::area) {
    weights_.assign(samples.weights.begin(), samples.weights.end());
  } else if (has_polygons(mesh)) {
    weights_ = polygon_shares(mesh);
  }
  if (!scoring.cuts) return;
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  edges_ = edges_of(mesh, merged);
  vertices_ = static_cast<std::int32_t>(mesh.vertices.rows());
  const double area = samples.weights.sum();
  const Eigen::RowVector3d centroid = samples.weights.transpose() * samples.points / area;
  radius_ = (samples.points.rowwise() - centroid).rowwise().norm().dot(samples.weights) / area;
}

SegmentationErrors SegmentationScorer::errors(const std::vector<std::int32_t>& labels,
                                              const std::vector<std::int32_t>& truth) const {
  SegmentationErrors errors = segmentation_errors(labels, truth, weights_);
  if (radius_ > 0) errors.cut_discrepancy = cut_discrepancy(labels, truth, edges_, vertices_, radius_);
  return errors;
}

SegmentationErrors SegmentationScorer::mean_errors_against(const std::vector<std::int32_t>& labels,
                                                           const std::vector<std::vector<std::int32_t>>& people) const {
  std::vector<SegmentationErrors> all;
  for (const std::vector<std::int32_t>& person : people) all.push_back(errors(labels, person));
  return mean_of(all);
}

SegmentationErrors SegmentationScorer::mean_errors_among(const std::vector<std::vector<std::int32_t>>& people) const {
  std::vector<SegmentationErrors> all;
  for (const std::vector<std::int32_t>& one : people) {
    for (const std::vector<std::int32_t>& other : people) {
      if (&one != &other) all.push_back(errors(one, other));
    }
  }
  return mean_of(all);
}

}  // namespace shapegauge
