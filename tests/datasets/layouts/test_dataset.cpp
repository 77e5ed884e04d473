// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(ModelFile, IsRecognisedByItsExtension) {
  for (const char* name : {"a.off", "a.OFF", "b.c.obj", "/x/a.ply", "a.stl", "a.xyz"}) {
    EXPECT_TRUE(is_model_file(name)) << name;
  }
  for (const char* name : {"a", "off", ".off", ".a.off", "a.txt", "a.off.bak", "/x.off/a", "a.off/"}) {
    EXPECT_FALSE(is_model_file(name)) << name;
  }
}

class FolderOfModels : public test::FolderTest {
 protected:
  void SetUp() override {
    for (const char* name : {"b10.off", "b9.off", "B1.ply", "notes.txt", ".hidden.off", "inner/c.off", "inner/x.md",
                             "inner/deep/d.off", "other/e.off", ".git/f.off"}) {
      test::write_text(root() / name, "x");
    }
    std::filesystem::create_symlink(root() / "inner", root() / "link");
    std::filesystem::create_symlink("nowhere", root() / "broken");
    std::filesystem::create_symlink("nowhere", root() / "broken.off");
    std::filesystem::create_symlink("circle", root() / "circle");
  }

  [[nodiscard]] std::filesystem::path root() const { return at("models"); }
  [[nodiscard]] static std::vector<std::string> names(const std::vector<std::filesystem::path>& paths) {
    std::vector<std::string> names;
    for (const std::filesystem::path& path : paths) names.push_back(path.filename().string());
    return names;
  }
  /// The entries skipped if these are the models.
  [[nodiscard]] SkippedEntries skipped(const std::vector<std::string>& files) const {
    std::vector<Model> models;
    for (const std::string& file : files) models.push_back({.id = file, .file = root() / file});
    return skipped_entries(root(), models);
  }
};

TEST_F(FolderOfModels, ListsItsModelsInNaturalOrder) {
  EXPECT_THAT(names(model_files(root())), testing::UnorderedElementsAre("B1.ply", "b9.off", "b10.off", "broken.off"));
  const std::vector<std::string> found = names(model_files(root()));
  EXPECT_LT(std::ranges::find(found, "b9.off"), std::ranges::find(found, "b10.off"));
  EXPECT_THROW(model_files(root() / "none"), InputError);
  EXPECT_THROW(model_files(root() / "b9.off"), InputError);
}

TEST_F(FolderOfModels, ListsSubfoldersAndLinks) {
  EXPECT_THAT(names(subfolders(root())), ElementsAre("broken", "circle", "inner", "link", "other"));
  EXPECT_THROW(subfolders(root() / "none"), InputError);
}

TEST_F(FolderOfModels, ListsEachUnvisitedSubfolderOnce) {
  std::filesystem::create_symlink(".", root() / "self");
  std::filesystem::create_symlink("..", root() / "up");
  std::filesystem::create_symlink("inner", root() / "alias");
  std::set<std::filesystem::path> visited = visited_at_root(root());
  EXPECT_THAT(names(unvisited(subfolders(root()), visited)), ElementsAre("broken", "circle", "inner", "other"));
  EXPECT_THAT(names(unvisited(subfolders(root() / "inner"), visited)), ElementsAre("deep"));
  EXPECT_TRUE(unvisited(subfolders(root() / "alias"), visited).empty());
}

TEST_F(FolderOfModels, FollowsLinksUnlessBrokenOrCircular) {
  EXPECT_TRUE(is_folder(root() / "link"));
  EXPECT_TRUE(is_readable_folder(root() / "link"));
  EXPECT_FALSE(is_broken_link(root() / "link"));
  for (const char* name : {"broken", "circle", "none", "b9.off"}) {
    EXPECT_FALSE(is_folder(root() / name)) << name;
    EXPECT_FALSE(is_readable_folder(root() / name)) << name;
  }
  EXPECT_TRUE(is_broken_link(root() / "broken"));
  EXPECT_TRUE(is_broken_link(root() / "circle"));
  EXPECT_FALSE(is_broken_link(root() / "none"));
  EXPECT_TRUE(is_cyclic_link(root() / "circle"));
  for (const char* name : {"broken", "link", "none"}) EXPECT_FALSE(is_cyclic_link(root() / name)) << name;
}

TEST_F(FolderOfModels, CountsSkippedEntriesInFoldersWithModels) {
  // At the top: notes.txt, broken and circle are no shapes; broken.off is one; inner, link and other are folders.
  const SkippedEntries top = skipped({"b10.off", "b9.off", "B1.ply"});
  EXPECT_EQ(top.files, 3U);
  EXPECT_EQ(top.shapes, 1U);
  EXPECT_EQ(top.folders, 3U);
  // With a model in it, the folder is searched as well: x.md and deep are skipped there.
  const SkippedEntries inner = skipped({"b10.off", "inner/c.off"});
  EXPECT_EQ(inner.files, 4U);
  EXPECT_EQ(inner.shapes, 3U);
  EXPECT_EQ(inner.folders, 3U);
  const SkippedEntries deep = skipped({"inner/deep/d.off"});
  EXPECT_EQ(deep.files, 4U);
  EXPECT_EQ(deep.shapes, 5U) << "c.off between them, too";
  EXPECT_EQ(deep.folders, 2U);
}

TEST(SkippedText, CountsSkippedFilesAndFolders) {
  EXPECT_EQ(skipped_text({}), "");
  EXPECT_THAT(skipped_text({.files = 3, .folders = 1}),
              AllOf(HasSubstr("3 files"), HasSubstr("1 folder"), Not(HasSubstr("outside"))));
  EXPECT_THAT(skipped_text({.shapes = 2}), AllOf(HasSubstr("2 shapes"), Not(HasSubstr("file"))));
}

}  // namespace

}  // namespace shapegauge
