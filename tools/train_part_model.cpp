// SPDX-License-Identifier: GPL-3.0-or-later
// Trains or evaluates the model of part_segmentation():
//
//     train_part_model SHAPES WEIGHTS.inc
//     train_part_model SHAPES
//     train_part_model SHAPES --ablate BENCHMARK
//
// SHAPES and BENCHMARK are data sets that `shapegauge dataset generate` made, whose shapes carry their parts, or
// segmentation benchmarks. Without a file to write it leaves out one class after the other, trains on the rest, and
// measures the Rand error on the class left out. --ablate leaves out one group of features after the other, trains on
// SHAPES, and measures on BENCHMARK.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_merging.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/surface_regions.h"
#include "shapegauge/tools/part_model_training.h"

namespace shapegauge {
namespace {

constexpr int none_left_out = -1;
constexpr int no_class = -2;  // for shapes that belong to no class
constexpr int training_patches = 150;

/// Mesh with its regions and human segmentations.
struct TrainingModel {
  std::vector<std::int32_t> patch;
  Regions regions{0};
  std::vector<std::vector<std::int32_t>> people;
  Eigen::MatrixXd together;
  int label = 0;
};

/// Makes an ellipsoid, which is one part: generated shapes have none.
Shape ellipsoid(const Eigen::Vector3d& radii) {
  constexpr int rings = 28;
  constexpr int sectors = 56;
  Shape shape;
  shape.vertices.resize((rings - 1) * sectors + 2, 3);
  shape.triangles.resize(Eigen::Index{2} * (rings - 1) * sectors, 3);
  const auto vertex = [](int ring, int sector) { return (ring - 1) * sectors + sector % sectors; };
  const int north = (rings - 1) * sectors;
  const int south = north + 1;
  for (int ring = 1; ring < rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (int sector = 0; sector < sectors; ++sector) {
      const double turn = 2 * std::numbers::pi * sector / sectors;
      const Eigen::Vector3d direction(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                                      std::cos(polar));
      shape.vertices.row(vertex(ring, sector)) = direction.cwiseProduct(radii).transpose();
    }
  }
  shape.vertices.row(north) << 0, 0, radii.z();
  shape.vertices.row(south) << 0, 0, -radii.z();
  Eigen::Index face = 0;
  for (int sector = 0; sector < sectors; ++sector) {
    shape.triangles.row(face++) << north, vertex(1, sector), vertex(1, sector + 1);
    shape.triangles.row(face++) << south, vertex(rings - 1, sector + 1), vertex(rings - 1, sector);
    for (int ring = 1; ring + 1 < rings; ++ring) {
      shape.triangles.row(face++) << vertex(ring, sector), vertex(ring + 1, sector), vertex(ring + 1, sector + 1);
      shape.triangles.row(face++) << vertex(ring, sector), vertex(ring + 1, sector + 1), vertex(ring, sector + 1);
    }
  }
  return shape;
}

/// Prepares a mesh for merging; `people` are the numbers of segments, by person and face.
TrainingModel prepared(const Shape& mesh, std::vector<std::vector<std::int32_t>> people) {
  const PartSegmentationOptions options;
  const ThickSurface surface = thick_surface(mesh);
  TrainingModel result;
  result.patch = patches(surface.graph, {.count = training_patches, .seed = options.seed}, patch_costs(surface));
  result.regions = surface_regions(surface, result.patch, options.samples);
  result.people = std::move(people);
  result.together = pairs_together(result.patch, result.regions.initial_size(), result.people);
  return result;
}

std::vector<TrainingModel> prepared(const SegmentationBenchmark& benchmark) {
  std::vector<TrainingModel> models(benchmark.models.size());
  parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    const SegmentedModel& model = benchmark.models[i];
    const Shape mesh = read_shape(model.mesh);
    std::vector<std::vector<std::int32_t>> people;
    for (const auto& file : model.people) people.push_back(read_seg(file, mesh));
    models[i] = prepared(mesh, std::move(people));
    models[i].label = model.label;
  });
  for (const double width : {1.0, 0.8, 0.6, 0.4}) {
    for (const double depth : {1.0, 0.8, 0.6, 0.4, 0.25}) {
      const Shape mesh = ellipsoid({width, width * depth, 1});
      models.push_back(prepared(mesh, {std::vector<std::int32_t>(static_cast<std::size_t>(mesh.triangles.rows()), 0)}));
      models.back().label = no_class;
    }
  }
  return models;
}

void add_examples(std::vector<PartExample>& examples, const std::vector<TrainingModel>& models, int left_out,
                  const PartModel* model) {
  for (const TrainingModel& training : models) {
    if (training.label == left_out) continue;
    const std::vector<PartExample> more = part_examples(training.regions, training.together, model);
    examples.insert(examples.end(), more.begin(), more.end());
  }
}

/// Trains a first model on merges by the labels, and a second one also on merges by the first.
PartModel trained(const std::vector<TrainingModel>& models, int left_out = none_left_out) {
  std::vector<PartExample> examples;
  add_examples(examples, models, left_out, nullptr);
  const PartModel first = train_part_model(examples, {.networks = 1});
  add_examples(examples, models, left_out, &first);
  return train_part_model(examples, {});
}

double rand_error(const TrainingModel& training, const PartModel& model) {
  Regions regions = training.regions;
  const auto probability = [&](const Regions& now, std::int32_t a, std::int32_t b) {
    return model.probability(features_of(now, a, b));
  };
  merge_regions(regions, probability, {.min_affinity = PartSegmentationOptions{}.min_probability});
  std::vector<std::int32_t> labels;
  for (const std::int32_t p : training.patch) labels.push_back(regions.region_of(p));
  double sum = 0;
  for (const auto& person : training.people) sum += segmentation_errors(labels, person).rand_index;
  return sum / static_cast<double>(training.people.size());
}

/// Returns the mean Rand error on the shapes of a class.
double class_error(const std::vector<TrainingModel>& shapes, int label, const PartModel& model) {
  double error = 0;
  int count = 0;
  for (const TrainingModel& shape : shapes) {
    if (shape.label != label) continue;
    error += rand_error(shape, model);
    ++count;
  }
  return error / count;
}

void cross_validate(const SegmentationBenchmark& benchmark, const std::vector<TrainingModel>& models) {
  double sum = 0;
  for (std::size_t c = 0; c < benchmark.classes.size(); ++c) {
    const auto label = static_cast<int>(c);
    const double error = class_error(models, label, trained(models, label));
    fmt::print("{:10} {:.4f}\n", benchmark.classes[c], error);
    std::fflush(stdout);
    sum += error;
  }
  fmt::print("{:10} {:.4f}\n", "mean", sum / static_cast<double>(benchmark.classes.size()));
}

/// Groups of features, by the names of their first ones.
struct FeatureGroup {
  std::string_view name;
  std::string_view first;
};

constexpr std::array<FeatureGroup, 5> feature_groups{{{"lines of sight", "seen shallow"},
                                                      {"thickness", "thickness apart"},
                                                      {"the border", "border concave"},
                                                      {"opposite sides", "opposite"},
                                                      {"form and size", "elongation small"}}};

/// Returns the half-open range of a group's features.
std::pair<Eigen::Index, Eigen::Index> range_of(std::size_t group) {
  const auto index_of = [](std::string_view name) {
    return std::ranges::find(region_feature_names(), name) - region_feature_names().begin();
  };
  const bool last = group + 1 == feature_groups.size();
  return {index_of(feature_groups.at(group).first),
          last ? region_features : index_of(feature_groups.at(group + 1).first)};
}

/// Trains a model without the features of a group.
PartModel model_without(std::size_t group, std::vector<PartExample> examples, const TrainingOptions& options) {
  const auto [begin, end] = range_of(group);
  for (PartExample& example : examples) example.features.segment(begin, end - begin).setZero();
  PartModel model = train_part_model(examples, options);
  model.hidden.middleCols(begin, end - begin).setZero();
  return model;
}

PartModel trained_without(std::size_t group, const std::vector<TrainingModel>& models) {
  std::vector<PartExample> examples;
  add_examples(examples, models, none_left_out, nullptr);
  const PartModel first = model_without(group, examples, {.networks = 1});
  add_examples(examples, models, none_left_out, &first);
  return model_without(group, std::move(examples), {});
}

/// Returns the mean of the classes' mean Rand errors.
double mean_error(const SegmentationBenchmark& benchmark, const std::vector<TrainingModel>& tests,
                  const PartModel& model) {
  double sum = 0;
  for (int label = 0; label < std::ssize(benchmark.classes); ++label) sum += class_error(tests, label, model);
  return sum / static_cast<double>(benchmark.classes.size());
}

void ablate(const SegmentationBenchmark& shapes, const SegmentationBenchmark& benchmark) {
  const std::vector<TrainingModel> models = prepared(shapes);
  const std::vector<TrainingModel> tests = prepared(benchmark);
  fmt::print("{:24} {:.4f}\n", "all features", mean_error(benchmark, tests, trained(models)));
  for (std::size_t group = 0; group < feature_groups.size(); ++group) {
    const double error = mean_error(benchmark, tests, trained_without(group, models));
    fmt::print("{:24} {:.4f}\n", fmt::format("without {}", feature_groups.at(group).name), error);
    std::fflush(stdout);
  }
}

template <typename Numbers>
void write_array(std::string& text, std::string_view name, std::string_view size, const Numbers& numbers) {
  constexpr Eigen::Index in_a_row = 12;
  fmt::format_to(std::back_inserter(text), "constexpr std::array<float, {}> {} = {{\n", size, name);
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    const bool ends = i % in_a_row == in_a_row - 1 || i + 1 == numbers.size();
    fmt::format_to(std::back_inserter(text), "{}{:#.5g}F,{}", i % in_a_row == 0 ? "    " : " ", numbers[i],
                   ends ? "\n" : "");
  }
  text += "};\n";
}

std::string weights_of(const PartModel& model) {
  Eigen::MatrixXd units(region_features + 2, model.output.size());
  units.topRows(region_features) = model.hidden.transpose();
  units.row(region_features) = model.hidden_bias.transpose();
  units.row(region_features + 1) = model.output.transpose();
  std::string text = "// Written by train_part_model: what part_model.h describes, learnt from generated shapes.\n";
  write_array(text, "feature_means", "region_features", model.mean);
  write_array(text, "feature_deviations", "region_features", model.deviation);
  write_array(text, "hidden_units", fmt::format("{}UL * (region_features + 2)", model.output.size()),
              Eigen::VectorXd(units.reshaped()));
  return text + fmt::format("constexpr float output_bias = {:#.6g}F;\n", model.output_bias);
}

SegmentationBenchmark benchmark_in(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "parts.json") ? find_generated_parts(folder)
                                                        : find_segmentation_benchmark(folder);
}

int run(const std::vector<std::string>& arguments) {
  const bool ablation = arguments.size() == 3 && arguments[1] == "--ablate";
  if (!ablation && (arguments.empty() || arguments.size() > 2)) {
    fmt::print(stderr, "usage: train_part_model SHAPES [WEIGHTS.inc | --ablate BENCHMARK]\n");
    return 2;
  }
  const SegmentationBenchmark shapes = benchmark_in(arguments[0]);
  if (ablation) {
    ablate(shapes, benchmark_in(arguments[2]));
  } else if (arguments.size() == 1) {
    cross_validate(shapes, prepared(shapes));
  } else {
    write_file_atomically(arguments[1], weights_of(trained(prepared(shapes))));
  }
  return 0;
}

}  // namespace
}  // namespace shapegauge

int main(int argc, char** argv) {
  try {
    return shapegauge::run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    fmt::print(stderr, "train_part_model: error: {}\n", error.what());
    return 2;
  }
}
