#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tbb/global_control.h>

#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/experiments/datasets/classification_file.h"
#include "shapegauge/experiments/generator/generate_dataset.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/generator/mesh_topology.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using test_io::bytes_of;
using test_io::TemporaryFolder;
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

TEST(GenerateDataset, WritesModelsLabelsPartsAndClassification) {
  const TemporaryFolder folder;
  const std::filesystem::path set = folder.path() / "new" / "set";
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
  const std::vector<std::string> names = generated_class_names();
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
  EXPECT_FALSE(std::is_sorted(numbers.begin(), numbers.end()));  // the order of files does not give the classes away
}

TEST(GenerateDataset, SameSeedSameBytesWithAnyNumberOfThreads) {
  const auto one = generated(small_options(), 1);
  EXPECT_EQ(one, generated(small_options(), 2));
  EXPECT_EQ(one, generated(small_options(), 2));
}

TEST(GenerateDataset, AnotherSeedGivesOtherModels) {
  GeneratorOptions options = small_options();
  options.classes = 1;
  const auto first = generated(options, 2);
  options.seed = 5;
  const auto second = generated(options, 2);
  for (const char* name : {"T0.off", "T1.off", "T2.off"}) {
    for (const char* other : {"T0.off", "T1.off", "T2.off"}) EXPECT_NE(first.at(name), second.at(other));
  }
}

TEST(GenerateDataset, NamesAreAtLeastTwelveAndUnique) {
  const std::vector<std::string> names = generated_class_names();
  EXPECT_GE(names.size(), 12U);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(GenerateDataset, RefusesOptionsOutOfRange) {
  const TemporaryFolder folder;
  const auto error_with = [&](auto change) {
    GeneratorOptions options = small_options();
    change(options);
    return input_error_of([&] { generate_dataset(folder.path(), options); });
  };
  EXPECT_THAT(error_with([](auto& o) { o.classes = 0; }), HasSubstr("classes = 0; choose from 1 to"));
  EXPECT_THAT(error_with([](auto& o) { o.classes = 1000; }), HasSubstr("classes = 1000"));
  EXPECT_THAT(error_with([](auto& o) { o.models_per_class = 0; }), HasSubstr("models per class = 0"));
  EXPECT_THAT(error_with([](auto& o) { o.faces = 999; }), HasSubstr("faces = 999; choose from 1000"));
  EXPECT_EQ(folder.size(), 0U);
}

TEST(GenerateDataset, RefusesAFolderThatCannotBeMade) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.file("file", "text");
  for (const auto& path : {file, file / "set"}) {
    EXPECT_THAT(input_error_of([&] { generate_dataset(path, small_options()); }),
                HasSubstr("cannot write a data set to " + path.string()));
  }
  EXPECT_EQ(bytes_of(file), "text");
}

TEST(GenerateDataset, ReplacesAnotherDataSetOnlyWhenForcedAndLeavesOtherFiles) {
  const TemporaryFolder folder;
  static_cast<void>(folder.file("T77.off", "old"));
  static_cast<void>(folder.file("notes.txt", "mine"));
  static_cast<void>(folder.file("T5.off.bak", "mine"));
  GeneratorOptions options = small_options();
  options.classes = 1;
  options.models_per_class = 1;
  EXPECT_THAT(input_error_of([&] { generate_dataset(folder.path(), options); }), HasSubstr("T77.off"));
  EXPECT_EQ(bytes_of(folder.path() / "T77.off"), "old");
  options.force = true;
  generate_dataset(folder.path(), options);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "T77.off"));
  EXPECT_EQ(bytes_of(folder.path() / "notes.txt"), "mine");
  EXPECT_EQ(bytes_of(folder.path() / "T5.off.bak"), "mine");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "T0.off"));
}

}  // namespace
}  // namespace shapegauge
