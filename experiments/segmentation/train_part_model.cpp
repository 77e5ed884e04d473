// Trains the model of part_segmentation(), or says by cross-validation over classes what it is worth:
// train_part_model SHAPES [WEIGHTS.inc]. SHAPES is a data set that `shapegauge dataset generate` made, whose shapes
// carry their parts, or a segmentation benchmark. Without a file to write it leaves out one class after the other,
// trains on the rest, and measures the Rand error on the class left out.
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <string>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/segmentation/segmentation_benchmark.h"
#include "shapegauge/segmentation/part_model_training.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_merging.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/surface_regions.h"

namespace shapegauge {
namespace {

constexpr int no_class = -2;  // of what belongs to no class that could be left out

/// A mesh as merging sees it, and what people say of it.
struct TrainingModel {
  std::vector<std::int32_t> patch;
  Regions regions{0};
  std::vector<std::vector<std::int32_t>> people;
  Eigen::MatrixXd together;
  int label = 0;
};

/// An ellipsoid of these radii, which is one part: what generated shapes do not show.
Shape ellipsoid(const Eigen::Vector3d& radii) {
  constexpr int rings = 28;
  constexpr int sectors = 56;
  Shape shape;
  shape.vertices.resize((rings - 1) * sectors + 2, 3);
  shape.triangles.resize(2 * (rings - 1) * sectors, 3);
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

/// A mesh as merging sees it; `people` are the numbers of segments, by person and face.
TrainingModel prepared(const Shape& mesh, std::vector<std::vector<std::int32_t>> people) {
  const PartSegmentationOptions options;
  const ThickSurface surface = thick_surface(mesh);
  TrainingModel result;
  result.patch = patches(surface.graph, {.count = options.patches, .seed = options.seed}, patch_costs(surface));
  result.regions = surface_regions(surface, result.patch, options.samples);
  result.people = std::move(people);
  result.together = pairs_together(result.patch, result.regions.initial_size(), result.people);
  return result;
}

std::vector<TrainingModel> prepared(const SegmentationBenchmark& benchmark) {
  std::vector<TrainingModel> models(benchmark.models.size());
  tbb::parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    const SegmentedModel& model = benchmark.models[i];
    const Shape mesh = read_shape(model.mesh);
    std::vector<std::vector<std::int32_t>> people;
    for (const auto& file : model.people)
      people.push_back(read_seg(file, static_cast<std::size_t>(mesh.triangles.rows())));
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

/// A first model learns from merging as people would, the second also from where the first one leads.
PartModel trained(const std::vector<TrainingModel>& models, int left_out) {
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
  merge_regions(regions, probability, {.least_affinity = PartSegmentationOptions{}.least_probability});
  std::vector<std::int32_t> labels;
  for (const std::int32_t p : training.patch) labels.push_back(regions.region_of(p));
  double sum = 0;
  for (const auto& person : training.people) sum += segmentation_errors(labels, person).rand_index;
  return sum / static_cast<double>(training.people.size());
}

void cross_validate(const SegmentationBenchmark& benchmark, const std::vector<TrainingModel>& models) {
  double sum = 0;
  for (std::size_t c = 0; c < benchmark.classes.size(); ++c) {
    const auto label = static_cast<int>(c);
    const PartModel model = trained(models, label);
    double error = 0;
    int count = 0;
    for (const TrainingModel& training : models) {
      if (training.label != label) continue;
      error += rand_error(training, model);
      ++count;
    }
    fmt::print("{:10} {:.4f}\n", benchmark.classes[c], error / count);
    sum += error / count;
  }
  fmt::print("{:10} {:.4f}\n", "mean", sum / static_cast<double>(benchmark.classes.size()));
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
  write_array(text, "hidden_units", fmt::format("{} * (region_features + 2)", model.output.size()),
              Eigen::VectorXd(units.reshaped()));
  return text + fmt::format("constexpr float output_bias = {:#.6g}F;\n", model.output_bias);
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.size() > 2) {
    fmt::print(stderr, "usage: train_part_model SHAPES [WEIGHTS.inc]\n");
    return 2;
  }
  const std::filesystem::path shapes = arguments[0];
  const SegmentationBenchmark benchmark = std::filesystem::exists(shapes / "parts.json")
                                              ? find_generated_parts(shapes)
                                              : find_segmentation_benchmark(shapes);
  const std::vector<TrainingModel> models = prepared(benchmark);
  if (arguments.size() == 1) {
    cross_validate(benchmark, models);
  } else {
    write_file_atomically(arguments[1], weights_of(trained(models, -1)));
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
