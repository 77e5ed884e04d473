// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/dataset_files.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class DatasetFiles : public test::FolderTest {
 protected:
  void SetUp() override {
    test::write_text(at("sets/animals.json"),
                     R"({"description": "Animals.", "layout": "folders", "root": "../animals", "split": "test"})");
    test::write_text(at("sets/named.json"), R"({"name": "The named", "layout": "shrec11", "root": "${NAMED_ROOT}"})");
  }
  Json read(Json document) const {
    read_dataset_files(document, "x.json", folder_.path(), pointers_);
    return document;
  }

  std::vector<std::string> pointers_{"/dataset", "/datasets/*"};
};

TEST_F(DatasetFiles, InConfigurationsAreReplacedByTheirContents) {
  const Json dataset = read({{"dataset", "sets/animals.json"}})["dataset"];
  EXPECT_EQ(dataset, (Json{{"layout", "folders"}, {"root", at("animals").string()}, {"split", "test"}}));
}

TEST_F(DatasetFiles, WithoutANameKeyAreNamedAfterTheFile) {
  const Json datasets =
      read({{"datasets", {"sets/animals.json", "sets/named.json", {{"name", "x"}, {"root", "y"}}}}})["datasets"];
  EXPECT_EQ(datasets[0]["name"], "animals");
  EXPECT_EQ(datasets[1]["name"], "The named");
  EXPECT_EQ(datasets[1]["root"], "${NAMED_ROOT}") << "which is looked up when the data set is read";
  EXPECT_EQ(datasets[2], (Json{{"name", "x"}, {"root", "y"}}));
}

TEST_F(DatasetFiles, ContentsCanBeChangedByOverrides) {
  test::write_text(at("run.json"), R"({"name": "x", "datasets": ["sets/animals.json"]})");
  const std::vector<std::string> overrides{"datasets.0.root=/elsewhere"};
  const auto paths = [&](const Json&) { return DocumentPaths{.datasets = pointers_}; };
  Json document = read_json(at("run.json"));
  const auto files = apply_overrides(document, "x.json", at(""), overrides, paths);
  EXPECT_EQ(document["datasets"][0]["root"], "/elsewhere");
  EXPECT_THAT(files, testing::ElementsAre(at("sets/animals.json")));
}

TEST_F(DatasetFiles, MustExistAndDescribeADataSet) {
  EXPECT_THAT(test::input_error_of([&] {
                read({{"dataset", "sets/absent.json"}});
              }),
              testing::AllOf(testing::StartsWith("x.json: dataset"), HasSubstr("absent.json")));
  test::write_text(at("sets/other.json"), R"({"name": "x"})");
  EXPECT_THAT(test::input_error_of([&] { read({{"dataset", "sets/other.json"}}); }), HasSubstr("other.json"));
  test::write_text(at("sets/broken.json"), "{");
  EXPECT_THAT(test::input_error_of([&] {
                read({{"datasets", {"sets/animals.json", "sets/broken.json"}}});
              }),
              testing::AllOf(testing::StartsWith("x.json: datasets.1: "), HasSubstr("broken.json")));
}

/// Files in configs/datasets, each with its environment variable and a folder of the expected layout.
struct PublishedDataset {
  std::string file;
  std::string variable;
  std::vector<std::string> models;
  std::string classification{};  ///< file of classes
  std::string classes{};         ///< contents
};

std::vector<PublishedDataset> published_datasets() {
  const std::string cla = "PSB 1\n1 2\n\nthing 0 2\n1\n2\n";
  const std::vector<std::string> psb{"db/0/m1/m1.off", "db/0/m2/m2.off"};
  const std::vector<std::string> splits{"a/train/a_1.off", "a/test/a_2.off", "b/test/b_1.off"};
  std::vector<PublishedDataset> all{
      {"shrec07", "SHREC07_ROOT", {"1.off", "400.off"}},
      {"mcgill", "MCGILL_ROOT", {"ants/1.ply", "crabs/2.ply"}},
      {"tosca", "TOSCA_ROOT", {"cat0.off", "dog1.off"}},
      {"esb", "ESB_ROOT", {"Flat/Clips/a.stl", "Round/Bolts/b.stl"}},
      {"modelnet10", "MODELNET10_ROOT", splits},
      {"modelnet40", "MODELNET40_ROOT", splits},
      {"shapenetcore_shrec17",
       "SHAPENET_SHREC_ROOT",
       {"test/model_1.obj", "test/model_2.obj"},
       "all.csv",
       "id,synsetId,subSynsetId,modelId,split\n1,x,y,a,test\n2,x,y,b,test\n3,x,y,c,train\n"}};
  for (const char* name : {"shrec10", "shrec11", "shrec15"}) {
    std::string variable = name;
    std::ranges::transform(variable, variable.begin(), [](unsigned char c) { return std::toupper(c); });
    all.push_back({name, variable + "_ROOT", {"T1.off", "T2.off"}, "test.cla", cla});
  }
  all.push_back({"shrec14_humans_real", "SHREC14_REAL_ROOT", {"1.obj", "2.obj"}, "test.cla", cla});
  all.push_back({"shrec14_humans_synthetic", "SHREC14_SYNTHETIC_ROOT", {"1.obj", "2.obj"}, "test.cla", cla});
  all.push_back({"psb_test", "PSB_ROOT", psb, "classification/v1/base/test.cla", cla});
  all.push_back({"psb_train", "PSB_ROOT", psb, "classification/v1/base/train.cla", cla});
  for (const char* level : {"1", "2", "3"}) {
    all.push_back({std::string("psb_test_coarse") + level, "PSB_ROOT", psb,
                   std::string("classification/v1/coarse") + level + "/test.cla", cla});
  }
  return all;
}

TEST(PublishedDatasets, AreDetectedByTheirFolderLayout) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SHAPEGAUGE_SOURCE_FOLDER "/configs/datasets")) {
    files += entry.path().extension() == ".json" ? 1 : 0;
  }
  EXPECT_EQ(published_datasets().size(), files) << "each file has a case here";
  for (const PublishedDataset& published : published_datasets()) {
    SCOPED_TRACE(published.file);
    const test::TemporaryFolder folder;
    for (const std::string& model : published.models) test::write_text(folder.path() / model, "OFF\n");
    if (!published.classes.empty()) test::write_text(folder.path() / published.classification, published.classes);
    ASSERT_EQ(setenv(published.variable.c_str(), folder.path().c_str(), 1), 0);
    const Json document{{"name", "x"},
                        {"dataset", "datasets/" + published.file + ".json"},
                        {"signatures", {{{"name", "d2"}, {"descriptor", {{"type", "d2"}}}}}}};
    const Configuration configuration =
        configuration_from_json(document, "x.json", SHAPEGAUGE_SOURCE_FOLDER "/configs");
    unsetenv(published.variable.c_str());
    const Dataset dataset = find_dataset(configuration.location.value());
    EXPECT_EQ(dataset.models.size(), 2U);
    for (const Model& model : dataset.models) EXPECT_TRUE(std::filesystem::exists(model.file)) << model.file;
    const bool table = published.classification.empty() || published.classification == "test.cla" ||
                       published.classification == "all.csv";
    const DatasetLocation recognised =
        recognise_dataset(folder.path(), table ? "" : folder.path() / published.classification);
    EXPECT_EQ(recognised.layout, configuration.location->layout);
  }
}

}  // namespace

}  // namespace shapegauge
