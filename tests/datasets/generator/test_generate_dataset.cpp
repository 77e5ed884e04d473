// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tbb/global_control.h>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/datasets/files/classification.h"
#include "shapegauge/datasets/generator/articulated_body.h"
#include "shapegauge/datasets/generator/class_skeletons.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/datasets/generator/mesh_implicit_surface.h"
#include "tests/datasets/generator/mesh_topology.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

constexpr int faces = 2000;

double min_height_to_length(const Shape& shape) {
  double least = 1;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(f, 2));
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    least = std::min(least, (b - a).cross(c - a).norm() / longest);
  }
  return least;
}

// Median over the edges of |length in a / length in b - 1|.
double edge_change(const Shape& a, const Shape& b) {
  std::vector<double> changes;
  for (Eigen::Index f = 0; f < a.triangles.rows(); ++f) {
    const int i = a.triangles(f, 0);
    const int j = a.triangles(f, 1);
    changes.push_back(
        std::abs((a.vertices.row(i) - a.vertices.row(j)).norm() / (b.vertices.row(i) - b.vertices.row(j)).norm() - 1));
  }
  std::nth_element(changes.begin(), changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2), changes.end());
  return changes[changes.size() / 2];
}

// Largest change of a distance between two vertices, relative to the diagonal.
double largest_distance_change(const Shape& a, const Shape& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.vertices.rows(); i += 7) {
    for (Eigen::Index j = 0; j < i; j += 7) {
      const double before = (a.vertices.row(i) - a.vertices.row(j)).norm();
      const double after = (b.vertices.row(i) - b.vertices.row(j)).norm();
      largest = std::max(largest, std::abs(before - after));
    }
  }
  return largest / bounding_box_diagonal(a);
}

class EveryArticulatedClass : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryArticulatedClass, HasValidMeshesInRandomPosesWithAllParts) {
  const ArticulatedBody body = make_articulated_body(class_skeleton(GetParam()), faces);
  EXPECT_NEAR(static_cast<double>(body.triangles.rows()), faces, 0.2 * faces);

  ASSERT_EQ(body.labels.size(), body.triangles.rows());
  const std::set<int> parts(body.labels.begin(), body.labels.end());
  EXPECT_EQ(parts.size(), body.skeleton.limbs.size());
  EXPECT_EQ(*parts.begin(), 0);
  EXPECT_EQ(*parts.rbegin(), static_cast<int>(body.skeleton.limbs.size()) - 1);

  const Shape rest{body.rest.points, body.triangles};
  EXPECT_EQ(topology_fault(rest), "");
  EXPECT_FALSE(self_intersects(rest));
  Shape previous = rest;
  double largest_bend = 0;
  for (std::uint64_t i = 0; i < 3; ++i) {
    RandomNumbers random(11, i);
    const Shape model = draw_model(body, random);
    EXPECT_EQ(topology_fault(model), "");
    EXPECT_FALSE(self_intersects(model));
    EXPECT_GT(min_height_to_length(model), 1e-3);
    EXPECT_TRUE(model.vertices.allFinite());
    // Individuals differ by 7 % at most each; a pose moves parts apart but hardly stretches the skin.
    EXPECT_LT(edge_change(model, previous), 0.15);
    EXPECT_NEAR(surface_area(model) / surface_area(rest), 1, 0.2);
    const double bend = largest_distance_change(model, previous);
    EXPECT_GT(bend, 0.01);
    largest_bend = std::max(largest_bend, bend);
    previous = model;
  }
  EXPECT_GT(largest_bend, 0.08);
}

INSTANTIATE_TEST_SUITE_P(Generator, EveryArticulatedClass, testing::Range(std::size_t{0}, articulated_class_count()),
                         [](const auto& parameter) { return class_skeleton(parameter.param).name; });

TEST(DrawModel, PosesChangeDistancesButHardlyEdgeLengths) {
  // The same individual (same first numbers) at rest and in its pose: distances change, edges hardly do.
  const ArticulatedBody body = make_articulated_body(class_skeleton(3), faces);  // octopus
  RandomNumbers random(1, 1);
  RandomNumbers same(1, 1);
  const Shape posed = draw_model(body, random);
  const Shape straight{draw_individual(body.skeleton, body.rest, body.weights, same).points, body.triangles};
  EXPECT_LT(edge_change(posed, straight), 0.05);
  EXPECT_GT(largest_distance_change(straight, posed), 0.2);
}

TEST(DrawModel, ThrowsIfNoPoseIsValid) {
  ArticulatedBody body = make_articulated_body(class_skeleton(11), 1000);  // lamp
  body.rest.points.col(2).setZero();
  RandomNumbers random(1);
  EXPECT_THROW(draw_model(body, random), std::runtime_error);
}

using test::bytes_of;
using test::TemporaryFolder;
using testing::HasSubstr;

GeneratorOptions small_options() {
  GeneratorOptions options;
  options.classes = 3;
  options.models_per_class = 3;
  options.faces = 1000;
  options.seed = 4;
  return options;
}

std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files[entry.path().filename().string()] = bytes_of(entry.path());
  }
  return files;
}

std::map<std::string, std::string> generated(const GeneratorOptions& options, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const TemporaryFolder folder;
  generate_dataset(folder.path(), options);
  return contents(folder.path());
}

using GenerateDataset = test::FolderTest;

TEST_F(GenerateDataset, WritesModelsLabelsPartsAndClassification) {
  const std::filesystem::path set = folder_.path() / "new" / "set";
  std::vector<int> progress;
  generate_dataset(set, small_options(), [&](int done, int total) {
    progress.push_back(done);
    EXPECT_EQ(total, 9);
  });
  EXPECT_EQ(progress, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(contents(set).size(), 9U + 9U + 2U);

  const Classification classification = read_classification(set / "test.cla");
  const nlohmann::json parts = nlohmann::json::parse(bytes_of(set / "parts.json"));
  ASSERT_EQ(classification.classes.size(), 3U);
  const std::span<const std::string_view> names = generated_model_parameters().front().choices;
  std::vector<std::string> numbers;
  for (std::size_t c = 0; c < 3; ++c) {
    const ModelClass& model_class = classification.classes[c];
    EXPECT_EQ(model_class.name, names[c]);
    ASSERT_EQ(model_class.models.size(), 3U);
    for (const std::string& model : model_class.models) {
      numbers.push_back(model);
      const Shape shape = read_shape(set / ("T" + model + ".off"));
      EXPECT_EQ(topology_fault(shape), "");
      std::istringstream labels(bytes_of(set / ("T" + model + ".seg")));
      std::set<int> seen;
      int count = 0;
      for (int label = 0; labels >> label; ++count) seen.insert(label);
      EXPECT_EQ(count, shape.triangles.rows());
      EXPECT_EQ(seen.size(), parts[model_class.name].size());
      EXPECT_EQ(*seen.rbegin() + 1, static_cast<int>(parts[model_class.name].size()));
    }
  }
  EXPECT_THAT(numbers, testing::UnorderedElementsAre("0", "1", "2", "3", "4", "5", "6", "7", "8"));
  EXPECT_FALSE(std::is_sorted(numbers.begin(), numbers.end()));  // the order of files does not reveal classes
}

TEST_F(GenerateDataset, WritesTheSameBytesForASeedOnAnyNumberOfThreads) {
  GeneratorOptions options = small_options();
  options.classes = 2;
  options.models_per_class = 2;
  EXPECT_EQ(generated(options, 1), generated(options, 2));
}

TEST_F(GenerateDataset, WritesDifferentModelsForAnotherSeed) {
  GeneratorOptions options = small_options();
  options.classes = 1;
  const auto first = generated(options, 2);
  options.seed = 5;
  const auto second = generated(options, 2);
  for (const char* name : {"T0.off", "T1.off", "T2.off"}) {
    for (const char* other : {"T0.off", "T1.off", "T2.off"}) EXPECT_NE(first.at(name), second.at(other));
  }
}

TEST_F(GenerateDataset, OffersAtLeastTwelveUniqueClassNames) {
  const std::span<const std::string_view> names = generated_model_parameters().front().choices;
  EXPECT_GE(names.size(), 12U);
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
}

TEST_F(GenerateDataset, RefusesOptionsOutOfRange) {
  const auto error_with = [&](auto change) {
    GeneratorOptions options = small_options();
    change(options);
    return test::input_error_of([&] { generate_dataset(folder_.path(), options); });
  };
  EXPECT_THAT(error_with([](auto& o) { o.classes = 0; }),
              HasSubstr("classes is 0; it must be a whole number from 1 to"));
  EXPECT_THAT(error_with([](auto& o) { o.classes = 1000; }), HasSubstr("classes is 1000"));
  EXPECT_THAT(error_with([](auto& o) { o.models_per_class = 0; }), HasSubstr("models_per_class is 0"));
  EXPECT_THAT(error_with([](auto& o) { o.faces = 999; }),
              HasSubstr("faces is 999; it must be a whole number from 1000"));
  EXPECT_EQ(folder_.size(), 0U);
}

TEST_F(GenerateDataset, StatesTheUpAxisInEachFile) {
  GeneratorOptions options = small_options();
  options.classes = options.models_per_class = 1;
  generate_dataset(folder_.path(), options);
  EXPECT_EQ(up_direction(UpAxis::automatic, folder_.path() / "T0.off"), Eigen::Vector3d(0, 0, 1));
}

// A failure means that generated models have changed: increase the version, so that cached comparisons of them are not
// used, and update the values here. Tolerances allow for other compilers, whose meshes differ.
TEST(GeneratorVersion, GeneratesModelsOfTheRecordedAreaAndDiagonal) {
  EXPECT_EQ(generator_version, 1);
  struct Recorded {
    const char* name;
    double area;
    double diagonal;
  };
  for (const auto& [name, area, diagonal] : {Recorded{"snake", 1.687, 3.362}, Recorded{"bracket", 4.034, 1.678}}) {
    const Shape shape = generate_model({.model_class = name, .model = 1, .faces = 1000, .seed = 3});
    EXPECT_NEAR(triangle_areas(shape).sum(), area, 0.01 * area) << name;
    EXPECT_NEAR(bounding_box_diagonal(shape), diagonal, 0.01 * diagonal) << name;
  }
}

TEST(GenerateModel, SuggestsTheNearestNameForAnUnknownClass) {
  EXPECT_THAT(test::input_error_of([] { generate_model({.model_class = "octopuss"}); }),
              HasSubstr("there is no generated class \"octopuss\"; did you mean \"octopus\"?"));
}

TEST_F(GenerateDataset, RejectsAFolderThatCannotBeCreated) {
  const std::filesystem::path file = folder_.file("file", "text");
  for (const auto& path : {file, file / "set"}) {
    EXPECT_THAT(test::input_error_of([&] { generate_dataset(path, small_options()); }),
                HasSubstr("cannot write a data set to " + path.string()));
  }
  EXPECT_EQ(bytes_of(file), "text");
}

TEST_F(GenerateDataset, ReplacesADataSetOnlyOnRequestAndKeepsUnrelatedFiles) {
  static_cast<void>(folder_.file("T77.off", "old"));
  static_cast<void>(folder_.file("notes.txt", "mine"));
  static_cast<void>(folder_.file("T5.off.bak", "mine"));
  GeneratorOptions options = small_options();
  options.classes = 1;
  options.models_per_class = 1;
  EXPECT_THAT(test::input_error_of([&] { generate_dataset(folder_.path(), options); }), HasSubstr("T77.off"));
  EXPECT_EQ(bytes_of(at("T77.off")), "old");
  options.replace = true;
  generate_dataset(folder_.path(), options);
  EXPECT_FALSE(std::filesystem::exists(at("T77.off")));
  EXPECT_EQ(bytes_of(at("notes.txt")), "mine");
  EXPECT_EQ(bytes_of(at("T5.off.bak")), "mine");
  EXPECT_TRUE(std::filesystem::exists(at("T0.off")));
}

}  // namespace

}  // namespace shapegauge
