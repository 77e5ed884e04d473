// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/datasets/layouts/layouts.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

const std::string triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// Folders with the layouts of published data sets and few models.
class BenchmarkLayouts : public test::FolderTest {
 protected:
  [[nodiscard]] fs::path root() const { return at("data"); }
  void add(const std::string& name, const std::string& text = triangle) const { test::write_text(root() / name, text); }

  /// Layout recognized for the folder, then models with their classes.
  [[nodiscard]] std::vector<std::string> recognised(const std::string& split = "all") const {
    DatasetLocation location = recognise_dataset(root());
    location.split = split;
    const Dataset dataset = find_dataset(location);
    std::vector<std::string> words{location.layout};
    for (const Model& model : dataset.models) {
      words.push_back(model.id + ":" + dataset.classes.at(static_cast<std::size_t>(model.label)));
    }
    EXPECT_TRUE(check_models(dataset).empty());
    return words;
  }
  [[nodiscard]] std::string error(const std::string& layout) const {
    return test::input_error_of([&] {
      static_cast<void>(find_dataset({.layout = layout,
                                      .root = root(),
                                      .classification = root() / dataset_layouts().at(layout).default_classification}));
    });
  }
};

TEST_F(BenchmarkLayouts, Shrec07ClassesFollowFromTheModelNumbers) {
  for (const char* name : {"1.off", "20.off", "21.off", "261.off", "400.off"}) add(name);
  EXPECT_THAT(recognised(), ElementsAre("shrec07", "1:human", "20:human", "21:cup", "261:spring", "400:fourleg"));
  add("401.off");
  EXPECT_THAT(error("shrec07"), HasSubstr("401.off"));
}

TEST_F(BenchmarkLayouts, Shrec10To15DataSetsAreRecognisedByTheirClassificationFile) {
  for (const char* name : {"T1.off", "T2.off", "T10.off"}) add(name);
  add("test.cla", "PSB 1\n2 3\n\nalien 0 2\n1\n10\n\ncat 0 1\n2\n");
  EXPECT_THAT(recognised(), ElementsAre("shrec11", "1:alien", "2:cat", "10:alien"));
}

TEST_F(BenchmarkLayouts, PrincetonModelsAreFoundInFoldersOfAHundred) {
  for (const char* name : {"db/0/m0/m0.off", "db/0/m7/m7.off", "db/8/m812/m812.off", "db/9/m900/m900.off"}) add(name);
  add("classification/v1/base/test.cla", "PSB 1\n3 3\n\nanimal 0 0\n\nbee animal 2\n0\n812\n\ncar 0 1\n7\n");
  add("classification/v1/coarse1/test.cla", "PSB 1\n1 3\n\nthing 0 3\n0\n812\n7\n");
  EXPECT_THAT(recognised(), ElementsAre("psb", "0:bee", "7:car", "812:bee"));
  const Dataset coarse =
      find_dataset({.layout = "psb", .root = root(), .classification = root() / "classification/v1/coarse1/test.cla"});
  EXPECT_EQ(coarse.classes.size(), 1U);
  add("classification/v1/base/test.cla", "PSB 1\n1 2\n\nbee 0 2\n0\nbumble\n");
  EXPECT_THAT(error("psb"), HasSubstr("bumble"));
}

TEST_F(BenchmarkLayouts, PrincetonModelsWithoutAFileAreReported) {
  add("db/0/m0/m0.off");
  add("classification/v1/base/test.cla", "PSB 1\n1 2\n\nbee 0 2\n0\n762\n");
  const Dataset dataset = find_dataset(recognise_dataset(root()));
  const std::vector<ModelFailure> failures = check_models(dataset);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_THAT(failures[0].message, HasSubstr("m762.off"));
}

TEST_F(BenchmarkLayouts, ToscaClassesFollowFromFileNames) {
  for (const char* name : {"cat0.off", "cat10.off", "cat2.off", "dog1.off"}) add(name);
  EXPECT_THAT(recognised(), ElementsAre("named", "cat0:cat", "cat2:cat", "cat10:cat", "dog1:dog"));
  add("wolf.off");
  EXPECT_THAT(error("named"), HasSubstr("wolf.off"));
}

TEST_F(BenchmarkLayouts, FolderTreeHasAClassForEachFolderWithModels) {
  for (const char* name : {"Flat/Clips/a.off", "Flat/Clips/b.off", "Flat/Plates/a.off", "Round/Bolts/c.off"}) add(name);
  EXPECT_THAT(recognised(), ElementsAre("tree", "Flat/Clips/a:Flat/Clips", "Flat/Clips/b:Flat/Clips",
                                        "Flat/Plates/a:Flat/Plates", "Round/Bolts/c:Round/Bolts"));
}

TEST_F(BenchmarkLayouts, EachFolderOfATreeIsListedOnceDespiteSymbolicLinks) {
  for (const char* name : {"Flat/Clips/a.off", "Flat/Plates/a.off", "Round/Bolts/c.off"}) add(name);
  const std::vector<std::string> models = recognised();
  const fs::path outside = at("outside");
  test::write_text(outside / "d.off", triangle);
  fs::create_symlink("loop", root() / "Flat/Clips/loop");
  fs::create_symlink("..", root() / "Flat/Clips/up");
  fs::create_symlink("../..", root() / "Flat/Clips/top");
  fs::create_symlink("../Round/Bolts", root() / "Flat/Bolts");
  fs::create_symlink(".", root() / "self");
  EXPECT_EQ(recognised(), models);
  const SkippedEntries skipped = find_dataset(recognise_dataset(root())).skipped;
  EXPECT_EQ(skipped.files, 1U) << "loop";
  EXPECT_EQ(skipped.folders, 4U);

  fs::create_symlink(outside, root() / "Flat/Outside");
  fs::create_symlink(outside, outside / "again");
  fs::create_symlink(root(), outside / "back");
  EXPECT_THAT(recognised(), ElementsAre("tree", "Flat/Clips/a:Flat/Clips", "Flat/Outside/d:Flat/Outside",
                                        "Flat/Plates/a:Flat/Plates", "Round/Bolts/c:Round/Bolts"));
}

TEST_F(BenchmarkLayouts, FolderTreeReportsUnreadableFolders) {
  for (const char* name : {"Flat/Clips/a.off", "Round/Bolts/c.off"}) add(name);
  fs::create_symlink("nowhere", root() / "Flat/Clips/lost");
  fs::create_directory(root() / "closed");
  fs::permissions(root() / "closed", fs::perms::none);
  fs::permissions(folder_.path(), fs::perms::all);
  std::vector<std::string> faulty;
  {
    const test::OrdinaryUser user;
    const DatasetLocation location = recognise_dataset(root());
    EXPECT_EQ(location.layout, "tree");
    const Dataset dataset = find_dataset(location);
    EXPECT_EQ(dataset.models.size(), 4U);
    for (const ModelFailure& failure : check_models(dataset)) faulty.push_back(dataset.models.at(failure.model).id);
  }
  EXPECT_THAT(faulty, UnorderedElementsAre("closed", "Flat/Clips/lost"));
  fs::permissions(root() / "closed", fs::perms::owner_all);
}

TEST_F(BenchmarkLayouts, FoldersLayoutWithLinksIsNotDetectedAsAFolderTree) {
  for (const char* name : {"A/a.off", "B/b.off", "B/train/c.off"}) add(name);
  const std::vector<std::string> models = recognised();
  EXPECT_EQ(models.front(), "folders");
  fs::create_symlink(".", root() / "self");
  fs::create_symlink("A", root() / "Alias");
  fs::create_symlink("..", root() / "A/up");
  fs::create_symlink(".", root() / "A/test");
  fs::create_directory(root() / "empty");
  fs::create_symlink("../B", root() / "empty/other");
  EXPECT_EQ(recognise_dataset(root()).layout, "folders");
  fs::remove_all(root() / "empty");
  EXPECT_EQ(recognised(), models);
}

TEST_F(BenchmarkLayouts, ModelNetIsDetectedAsFoldersWithSplits) {
  for (const char* name :
       {"bed/train/bed_1.off", "bed/test/bed_2.off", "sofa/train/sofa_1.off", "sofa/test/sofa_2.off"})
    add(name);
  EXPECT_THAT(recognised("test"), ElementsAre("folders", "bed/test/bed_2:bed", "sofa/test/sofa_2:sofa"));
}

TEST_F(BenchmarkLayouts, ShapeNetTableGivesSplitsAndSynsets) {
  const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* name : {"train/04090263/model_000001.obj", "test/model_000002.obj", "test/model_000003.obj"})
    add(name, triangle_obj);
  add("all.csv",
      "id,synsetId,subSynsetId,modelId,split\n000001,04090263,x,a,train\n000002,04090263,x,b,test\n"
      "000003,02691156,y,c,test\n");
  EXPECT_THAT(recognised(), ElementsAre("shapenet", "000001:04090263", "000002:04090263", "000003:02691156"));
  EXPECT_THAT(recognised("test"), ElementsAre("shapenet", "000002:04090263", "000003:02691156"));
  add("all.csv", "id,synsetId,subSynsetId,modelId,split\n000002,04090263,04090263,b,test\n000003,02691156,2,c,test\n");
  const Dataset dataset = find_dataset(recognise_dataset(root()));
  EXPECT_EQ(dataset.models[0].subclass, "");  // of the class as such
  EXPECT_EQ(dataset.models[1].subclass, "2");
  add("all.csv", "ID;SynsetID;Split\n000003;02691156;test\n");
  EXPECT_THAT(recognised(), ElementsAre("shapenet", "000003:02691156"));
  add("all.csv", "id,synsetId,split\n000001,1\n");
  EXPECT_THAT(error("shapenet"), HasSubstr(":2:"));
  add("all.csv", "id,class\n000001,1\n");
  EXPECT_THAT(error("shapenet"), HasSubstr("synsetId"));
}

}  // namespace

}  // namespace shapegauge
