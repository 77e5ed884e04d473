// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <map>
#include <string>
#include <sys/stat.h>

#include "shapegauge/datasets/layouts/layouts.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class DatasetLayouts : public test::FolderTest {
 protected:
  [[nodiscard]] fs::path root() const { return at("data"); }
  void write(const std::string& name, const std::string& text = off) const { write_text(root() / name, text); }

  [[nodiscard]] Dataset find(const std::string& layout, const std::string& split = "all") const {
    return find_dataset({.layout = layout,
                         .root = root(),
                         .classification = root() / dataset_layouts().at(layout).default_classification,
                         .split = split});
  }
  [[nodiscard]] std::string error(const std::string& layout, const std::string& split = "all") const {
    return test::input_error_of([&] { static_cast<void>(find(layout, split)); });
  }
};

std::vector<std::string> ids(const Dataset& dataset) {
  std::vector<std::string> all;
  for (const Model& model : dataset.models)
    all.push_back(model.id + ":" + dataset.classes.at(static_cast<std::size_t>(model.label)));
  return all;
}

TEST_F(DatasetLayouts, Shrec11ListsTheModelsOfTheClassificationInNaturalOrder) {
  for (const char* name : {"T2.off", "T10.off", "T3.off", "T99.off", "notes.txt"}) write(name);
  write("test.cla", "PSB 1\n2 3\na 0 2\n10\n2\nb 0 1\n3\n");
  const Dataset dataset = find("shrec11");
  EXPECT_THAT(ids(dataset), ElementsAre("2:a", "3:b", "10:a"));
  EXPECT_EQ(dataset.models[2].file, root() / "T10.off");
  EXPECT_TRUE(check_models(dataset).empty());
}

TEST_F(DatasetLayouts, Shrec11ModelsWithoutAFileAreReported) {
  write("T0.off");
  write("test.cla", "PSB 1\n1 2\na 0 2\n0\n1\n");
  const std::vector<ModelFailure> failures = check_models(find("shrec11"));
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].model, 1U);
  EXPECT_THAT(failures[0].message, HasSubstr("T1.off"));
}

TEST_F(DatasetLayouts, ReportFilesThatAreNotShapes) {
  write("T0.off", "hello\n");
  write("T1.off", "");
  write("T2.off");
  write("test.cla", "PSB 1\n1 3\na 0 3\n0\n1\n2\n");
  const std::vector<ModelFailure> failures = check_models(find("shrec11"));
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_THAT(failures[0].message, HasSubstr("T0.off"));
  EXPECT_THAT(failures[1].message, HasSubstr("T1.off"));
}

TEST_F(DatasetLayouts, Shrec11NeedsAClassificationAndOneFileForEachModel) {
  write("T1.off");
  EXPECT_THAT(error("shrec11"), HasSubstr("test.cla"));
  write("1.obj");
  write("test.cla", "PSB 1\n1 1\na 0 1\n1\n");
  EXPECT_THAT(error("shrec11"), HasSubstr("both the model 1"));
}

TEST_F(DatasetLayouts, RejectPathsThatAreNotFolders) {
  for (const DatasetLayout& layout : dataset_layouts().entries()) {
    EXPECT_THAT(error(std::string(layout.name)), HasSubstr("data: no such folder")) << layout.name;
  }
  write_text(root(), "x");
  EXPECT_THAT(error("folders"), HasSubstr("is not a folder"));
}

TEST(LayoutRegistry, RefusesALayoutWithoutAFunctionThatFindsModels) {
  EXPECT_THROW(dataset_layouts().add({.name = "test_none"}), ArgumentError);
  EXPECT_EQ(dataset_layouts().find("test_none"), nullptr);
}

TEST_F(DatasetLayouts, FoldersLayoutHasOneFolderPerClass) {
  for (const char* name : {"chair/c10.off", "chair/c2.OBJ", "bed/b1.ply", "bed/readme.txt", "bed/.hidden.off"})
    write(name);
  write(".git/x.off");
  EXPECT_THAT(ids(find("folders")), ElementsAre("bed/b1:bed", "chair/c2:chair", "chair/c10:chair"));
}

TEST_F(DatasetLayouts, AcceptPointCloudsAsModels) {
  const std::string xyz = "0 0 0\n1 0 0\n";
  for (const char* name : {"a/1.xyz", "a/2.PWN", "b/3.pts"}) write(name, xyz);
  write("b/readme.txt", "hello\n");
  EXPECT_THAT(ids(find("folders")), ElementsAre("a/1:a", "a/2:a", "b/3:b"));
  EXPECT_TRUE(check_models(find("folders")).empty());
  write("models.csv", "id,path,class\n1,a/1.xyz,a\n2,b/4.txt,b\n");
  write("b/4.txt", xyz);
  EXPECT_TRUE(check_models(find("csv")).empty());
  write("test.cla", "PSB 1\n1 2\na 0 2\n7\n8\n");
  write("T7.off", "OFF\n2 0 0\n" + xyz);
  write("T8.pwn", xyz);
  EXPECT_TRUE(check_models(find("shrec11")).empty());
}

TEST_F(DatasetLayouts, FoldersLayoutSelectsTheRequestedSplit) {
  for (const char* name : {"a/train/1.off", "a/test/2.off", "b/train/3.off", "b/test/4.off"}) write(name);
  EXPECT_THAT(ids(find("folders", "test")), ElementsAre("a/test/2:a", "b/test/4:b"));
  EXPECT_THAT(ids(find("folders", "train")), ElementsAre("a/train/1:a", "b/train/3:b"));
  EXPECT_EQ(find("folders").models.size(), 4U);
}

TEST_F(DatasetLayouts, CountFilesThatAreSkipped) {
  for (const char* name : {"chair/train/c1.off", "bed/b1.ply", "bed/test/b2.off"}) write(name);
  EXPECT_EQ(skipped_text(find("folders").skipped), "");
  for (const char* name : {"readme.txt", "bed/notes.txt", "chair/train/c1.mtl", "chair/deep/er/c4.off", "loose.off",
                           ".git/x.off", "bed/.b1.ply"}) {
    write(name);
  }
  const auto counts = [](const SkippedEntries& skipped) {
    return std::vector{skipped.files, skipped.shapes, skipped.folders};
  };
  EXPECT_THAT(counts(find("folders").skipped), ElementsAre(3, 1, 1));
  EXPECT_EQ(skipped_text(find("folders").skipped),
            "skipped: 3 files that are not shapes, 1 shape outside of the layout, 1 folder");
  // Each folder must have models; "chair" has some in "train" only.
  write("bed/train/b3.off");
  EXPECT_THAT(counts(find("folders", "train").skipped), ElementsAre(3, 1, 1));
}

TEST_F(DatasetLayouts, CountNoSkippedFilesIfAClassificationListsTheModels) {
  for (const char* name : {"T0.off", "T1.off", "readme.txt", "more/x.off"}) write(name);
  write("test.cla", "PSB 1\n1 1\na 0 1\n0\n");
  EXPECT_EQ(skipped_text(find("shrec11").skipped), "");
}

TEST_F(DatasetLayouts, FoldersLayoutRejectsMissingAndDuplicateModels) {
  write("T1.off");
  EXPECT_THAT(error("folders"), HasSubstr("folder for each class"));
  write("a/readme.txt");
  EXPECT_THAT(error("folders"), HasSubstr("a: no models"));
  write("a/x.off");
  write("a/x.obj");
  EXPECT_THAT(error("folders"), HasSubstr("another file has the same model id, a/x"));
  EXPECT_THAT(error("folders", "train"), HasSubstr("for the split \"train\""));
}

TEST_F(DatasetLayouts, FoldersLayoutNamesLinksThatAreNotFollowed) {
  fs::create_directories(root() / "ant");
  fs::create_directory_symlink("..", root() / "ant/train");
  const auto not_followed = [&](const std::string& link) {
    return HasSubstr((root() / link).string() + " is a link to a folder that contains it or was visited before");
  };
  EXPECT_THAT(error("folders"), testing::AllOf(HasSubstr("ant: no models"), not_followed("ant/train")));
  fs::remove_all(root() / "ant");
  EXPECT_THAT(error("folders"), testing::Not(HasSubstr("is a link")));
  fs::create_directory_symlink(".", root() / "ant");
  EXPECT_THAT(error("folders"), testing::AllOf(HasSubstr("found none"), not_followed("ant")));
  fs::create_symlink("circle", root() / "circle");
  EXPECT_THAT(test::input_error_of(
                  [&] { find_dataset({.layout = "folders", .root = root() / "circle", .classification = {}}); }),
              HasSubstr("circle: symbolic links lead in a circle"));
}

TEST_F(DatasetLayouts, CsvLayoutReadsModelsFromTheTable) {
  write("sub/x.off");
  write("models.csv", "id,path,class,Subcategory\n1,a.off,red,dark\n2,b.off,red,\n3,c.off,red,red\n");
  EXPECT_EQ(find("csv").models[0].subclass, "dark");
  EXPECT_EQ(find("csv").models[1].subclass, "");
  EXPECT_EQ(find("csv").models[2].subclass, "");
  write("models.csv", "class,id,path,remark\r\nred,m10,\"sub/x.off\",\r\nblue,m2,sub/x.off,\"a, b\"\r\n");
  const Dataset dataset = find("csv");
  EXPECT_THAT(ids(dataset), ElementsAre("m2:blue", "m10:red"));
  EXPECT_EQ(dataset.models[0].file, root() / "sub/x.off");
}

TEST_F(DatasetLayouts, CsvLayoutAcceptsColumnNamesInAnyCaseAndAnySeparator) {
  for (const char* text : {"ID;Path;Class\nm10;sub/x.off;red\nm2;\"sub/x.off\";blue, light\n",
                           "CLASS\tid\tPATH\nred\tm10\tsub/x.off\nblue, light\tm2\tsub/x.off\n",
                           "\xEF\xBB\xBFName,File,Label\r\nm10,sub/x.off,red\r\nm2,sub/x.off,\"blue, light\"\r\n"}) {
    write("models.csv", text);
    const Dataset dataset = find("csv");
    EXPECT_THAT(ids(dataset), ElementsAre("m2:blue, light", "m10:red")) << text;
    EXPECT_EQ(dataset.models[0].file, root() / "sub/x.off") << text;
  }
}

TEST_F(DatasetLayouts, CsvLayoutNamesTheLineOfAnError) {
  test::expect_refused({{"", "models.csv"},
                        {"id,path,class\n", "no models"},
                        {"id,place,class\n1,x,a\n", "models.csv:1: "},
                        {"id,path,class\n1,x\n", "models.csv:2: "},
                        {"id,path,class\n1,x,\n", "models.csv:2: the class"},
                        {"id,path,class\n1,x,a\n1,y,b\n", "models.csv:3: repeated model 1"}},
                       [&](const std::string& text) {
                         write("models.csv", text);
                         static_cast<void>(find("csv"));
                       });
}

TEST_F(DatasetLayouts, AreDetectedByTheFilesOfTheFolder) {
  write("a/1.off");
  EXPECT_EQ(recognise_dataset(root()).layout, "folders");
  write("models.csv");
  EXPECT_EQ(recognise_dataset(root()).layout, "csv");
  write("test.cla");
  EXPECT_EQ(recognise_dataset(root()).layout, "shrec11");
  EXPECT_EQ(recognise_dataset(root(), "other.csv").layout, "csv");
  EXPECT_EQ(recognise_dataset(root(), "OTHER.TSV").layout, "csv");
  EXPECT_EQ(recognise_dataset(root(), "other.cla").classification, "other.cla");
}

/// Messages of models that fail, by id.
std::map<std::string, std::string> failures_of(const Dataset& dataset) {
  std::map<std::string, std::string> messages;
  for (const ModelFailure& failure : check_models(dataset))
    messages[dataset.models[failure.model].id] = failure.message;
  return messages;
}

TEST_F(DatasetLayouts, FoldersLayoutReportsModelsThatAreNotRegularFiles) {
  write("ant/1.off");
  fs::create_symlink("loop.off", root() / "ant/loop.off");
  fs::create_symlink("nothing", root() / "ant/broken.off");
  fs::create_directory(root() / "ant/folder.off");
  ASSERT_EQ(mkfifo((root() / "ant/pipe.off").c_str(), 0600), 0);
  const Dataset dataset = find("folders");
  EXPECT_THAT(ids(dataset),
              ElementsAre("ant/1:ant", "ant/broken:ant", "ant/folder:ant", "ant/loop:ant", "ant/pipe:ant"));
  const auto failures = failures_of(dataset);
  EXPECT_EQ(failures.size(), 4U);
  for (const char* const name : {"broken", "folder", "loop", "pipe"}) {
    EXPECT_THAT(failures.at("ant/" + std::string(name)), HasSubstr(name + std::string(".off: ")));
  }
}

TEST_F(DatasetLayouts, FoldersLayoutReportsEmptyClasses) {
  write("ant/1.off");
  write("bee/readme.txt");
  write("cow/test/1.off");
  const Dataset dataset = find("folders");
  EXPECT_THAT(ids(dataset), ElementsAre("ant/1:ant", "bee:bee", "cow/test/1:cow"));
  const auto failures = failures_of(dataset);
  EXPECT_EQ(failures.size(), 1U);
  EXPECT_THAT(failures.at("bee"), HasSubstr("bee: no models"));
  const Dataset tests = find("folders", "test");
  EXPECT_THAT(ids(tests), ElementsAre("ant:ant", "bee:bee", "cow/test/1:cow"));
  EXPECT_THAT(failures_of(tests).at("ant"), HasSubstr("for the split \"test\""));
}

TEST_F(DatasetLayouts, FoldersLayoutReportsUnreadableFolders) {
  write("ant/1.off");
  write("bee/1.off");
  write("cow/train/1.off");
  write("cow/test/2.off");
  fs::create_symlink("dog", root() / "dog");
  fs::create_symlink("nothing", root() / "readme.txt");
  fs::permissions(root() / "bee", fs::perms::none);
  fs::permissions(root() / "cow/test", fs::perms::none);
  {
    fs::permissions(root().parent_path(), fs::perms::all);
    const test::OrdinaryUser user;
    const Dataset dataset = find("folders");
    EXPECT_THAT(ids(dataset), ElementsAre("ant/1:ant", "bee:bee", "cow/test:cow", "cow/train/1:cow", "dog:dog"));
    const auto failures = failures_of(dataset);
    EXPECT_EQ(failures.size(), 3U);
    EXPECT_THAT(failures.at("bee"), HasSubstr("Permission denied"));
    EXPECT_THAT(failures.at("cow/test"), HasSubstr("Permission denied"));
    EXPECT_THAT(failures.at("dog"), HasSubstr("symbolic links"));
  }
  for (const char* const folder : {"bee", "cow/test"}) fs::permissions(root() / folder, fs::perms::owner_all);
}

TEST_F(DatasetLayouts, ReportModelsWhosePathIsAFolderOrACircularLink) {
  write("T0.off");
  fs::create_symlink("T1.off", root() / "T1.off");
  fs::create_directory(root() / "T2.off");
  fs::create_symlink("T99.off", root() / "T99.off");
  write("test.cla", "PSB 1\n1 3\na 0 3\n0\n1\n2\n");
  write("models.csv", "id,path,class\n0,T0.off,a\n1,T1.off,a\n2,T2.off,a\n");
  for (const char* const layout : {"shrec11", "csv"}) {
    const auto failures = failures_of(find(layout));
    EXPECT_EQ(failures.size(), 2U) << layout;
    EXPECT_THAT(failures.at("1"), HasSubstr("T1.off")) << layout;
    EXPECT_THAT(failures.at("2"), HasSubstr("T2.off")) << layout;
  }
}

}  // namespace

}  // namespace shapegauge
