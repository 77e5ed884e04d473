// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/search/searched_folder.h"

namespace shapegauge {
namespace {

using test::input_error_of;
using test::SearchedFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> ids_of(const Collection& collection) {
  std::vector<std::string> ids;
  for (const CollectionFile& file : collection.files) ids.push_back(file.id);
  return ids;
}

class FindCollection : public test::FolderTest {
 protected:
  FindCollection() {
    for (const char* name : {"a10.off", "a9.OBJ", "deep/er/b.stl", ".hidden/c.off", "notes.txt", ".d.off"}) {
      test::write_text(at(name), "x");
    }
  }
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / "models" / name; }
  [[nodiscard]] std::filesystem::path written(const std::string& name, const std::string& text) const {
    test::write_text(at(name), text);
    return at(name);
  }
};

TEST_F(FindCollection, ReadsFoldersRecursively) {
  std::filesystem::create_directory_symlink(at(""), at("deep/circle"));
  const Collection found = find_collection(at(""));
  EXPECT_THAT(ids_of(found), ElementsAre("a9.OBJ", "a10.off", "deep/er/b.stl"));
  EXPECT_TRUE(std::filesystem::exists(found.file(found.files[2].path)));
  EXPECT_EQ(found.skipped.files, 1U);
  EXPECT_EQ(found.skipped.folders, 1U);  // the circle
}

TEST_F(FindCollection, ListsALinkedFolderOnceUnderItsRealPath) {
  std::filesystem::create_directory(at("a"));
  std::filesystem::create_directory_symlink(at("deep/er"), at("a/alias"));
  std::filesystem::create_directory_symlink(at("deep"), at("b"));
  const Collection found = find_collection(at(""));
  EXPECT_THAT(ids_of(found), ElementsAre("a9.OBJ", "a10.off", "deep/er/b.stl"));
  EXPECT_EQ(found.skipped.folders, 2U);
}

TEST_F(FindCollection, ReadsListsOfFiles) {
  const Collection found = find_collection(written("list.txt", "# shapes\n\n deep/er/b.stl \r\na10.off\n"));
  EXPECT_THAT(ids_of(found), ElementsAre("a10.off", "deep/er/b.stl"));
  EXPECT_TRUE(std::filesystem::exists(found.file(found.files[1].path)));
  EXPECT_THAT(input_error_of([&] { find_collection(written("twice.txt", "a10.off\na10.off\n")); }),
              HasSubstr("names a10.off twice"));
  EXPECT_THAT(input_error_of([&] { find_collection(written("none.txt", "#\n")); }), HasSubstr("has no shapes"));
}

TEST_F(FindCollection, ReadsDataSets) {
  const auto table = written("models.csv", "id,path,class\none,a10.off,x\ntwo,deep/er/b.stl,y\n");
  EXPECT_THAT(ids_of(find_collection(table)), ElementsAre("one", "two"));
  const auto configuration = written(
      "experiment.json", R"({"name": "n", "dataset": {"layout": "csv", "root": ".", "classification": "models.csv"}})");
  const Collection found = find_collection(configuration);
  EXPECT_THAT(ids_of(found), ElementsAre("one", "two"));
  EXPECT_TRUE(std::filesystem::exists(found.file(found.files[1].path)));
  const SearchedFolder small;
  EXPECT_EQ(find_collection(small.models() / "test.cla").files.size(), 9U);
}

TEST_F(FindCollection, AcceptsAConfigurationThatNamesADatasetFile) {
  test::write_text(at("models.csv"), "id,path,class\none,a10.off,x\ntwo,deep/er/b.stl,y\n");
  test::write_text(at("sets/ds.json"), R"({"description": "Two shapes.", "layout": "csv", "root": ".."})");
  const auto configuration = written("run.json", R"({"name": "n", "dataset": "sets/ds.json"})");
  EXPECT_THAT(ids_of(find_collection(configuration)), ElementsAre("one", "two"));
  EXPECT_EQ(collection_base(configuration), std::filesystem::absolute(at("")).lexically_normal());
  test::write_text(at("sets/ds.json"), R"({"generate": {}})");
  EXPECT_THAT(input_error_of([&] { find_collection(configuration); }), HasSubstr("of files on disk"));
  EXPECT_THAT(input_error_of([&] { find_collection(written("run.json", R"({"dataset": "absent.json"})")); }),
              AllOf(HasSubstr("run.json: dataset: "), HasSubstr("absent.json: no such file")));
}

TEST_F(FindCollection, ErrorsNameTheKeyOfAnInvalidDataSet) {
  for (const auto& [dataset, message] : {std::pair(R"({})", "run.json: dataset: "),
                                         {R"({"layout": "folders", "root": 3})", "run.json: dataset.root: "},
                                         {R"({"layout": "shrec07", "root": ".", "split": "test"})", "dataset.split: "},
                                         {"null", "run.json: dataset: "}}) {
    const auto configuration = written("run.json", fmt::format(R"({{"name": "n", "dataset": {}}})", dataset));
    EXPECT_THAT(input_error_of([&] { find_collection(configuration); }),
                AllOf(HasSubstr(message), Not(HasSubstr("json.exception"))))
        << dataset;
  }
}

TEST_F(FindCollection, RejectsMissingFilesSingleShapesAndEmptyFolders) {
  EXPECT_THAT(input_error_of([&] { find_collection(at("absent")); }), HasSubstr("No such file"));
  EXPECT_THAT(input_error_of([&] { find_collection(at("a10.off")); }), HasSubstr("is not a collection"));
  EXPECT_THAT(input_error_of([&] { find_collection(written("no.json", R"({"name": "n"})")); }),
              HasSubstr("\"dataset\""));
  std::filesystem::create_directory(at("empty"));
  EXPECT_THAT(input_error_of([&] { find_collection(at("empty")); }), HasSubstr("has no shapes"));
}

TEST(DefaultIndexPath, IsNextToTheCollection) {
  EXPECT_EQ(default_index_path("/a/models"), "/a/models.search-index");
  EXPECT_EQ(default_index_path("/a/models/"), "/a/models.search-index");
  EXPECT_EQ(default_index_path("/a/list.txt", "b/own.json"), "/a/list.txt.own.search-index");
}

}  // namespace
}  // namespace shapegauge
