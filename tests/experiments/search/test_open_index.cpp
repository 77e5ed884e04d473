// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

#include "tests/experiments/search/searched_folder.h"

namespace shapegauge {
namespace {

using test::input_error_of;
using test::SearchedFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> ids_in(const OpenIndex& index) {
  std::vector<std::string> ids;
  for (const IndexedFile& model : index.contents.models) ids.push_back(model.id);
  return ids;
}

/// Bytes of an index of the folder built from scratch.
std::string bytes_from_scratch(const SearchedFolder& folder) {
  Cache none;
  IndexUpdate update;
  const OpenIndex index = open_index(folder.method(), folder.models(), folder.at("scratch"), {}, none, update);
  return encode_index(index.contents, index.method.key());
}

void make_old(const SearchedFolder& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder.models())) {
    std::filesystem::last_write_time(entry, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  }
}

class OpenIndexOfAFolder : public testing::Test {
 protected:
  const SearchedFolder folder;
};

TEST_F(OpenIndexOfAFolder, IsComputedOnceAndReadAfterwards) {
  make_old(folder);
  IndexUpdate first;
  const OpenIndex index = folder.open(first);
  EXPECT_TRUE(first.rebuilt);
  EXPECT_THAT(first.notes, IsEmpty());
  EXPECT_EQ(index.contents.models.size(), 9U);
  const std::string bytes = test::bytes_of(folder.index());
  IndexUpdate second;
  const OpenIndex again = folder.open(second);
  EXPECT_FALSE(second.rebuilt);
  EXPECT_EQ(encode_index(again.contents, again.method.key()), bytes);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes);
}

TEST_F(OpenIndexOfAFolder, ExcludesShapesThatTheMethodCannotDescribe) {
  test::replace_by_cloud(folder.models() / "T4.off");  // it has D2, but no conventional SDF
  IndexUpdate update;
  OpenIndex index = folder.open(update);
  EXPECT_EQ(index.contents.models.size(), 8U);
  for (const IndexTable& table : index.contents.tables) {
    EXPECT_EQ(table.rows, 8);
    EXPECT_TRUE(table.signatures().allFinite());
  }
  ASSERT_EQ(update.left_out.size(), 1U);
  EXPECT_THAT(update.left_out[0].id, HasSubstr("T4"));
  EXPECT_THAT(update.left_out[0].message, HasSubstr("needs triangles"));
  Cache none;
  const std::vector<SearchQuery> queries{{.name = "cloud", .file = folder.models() / "T4.off"}};
  std::vector<std::string> notes;
  EXPECT_THAT(search(index, queries, {}, {}, none, notes)[0].failure, HasSubstr("needs triangles"));
}

TEST_F(OpenIndexOfAFolder, IsUpdatedForAddedChangedAndRemovedFiles) {
  folder.open();
  folder.add("T9.off", "box", 9);
  make_old(folder);
  IndexUpdate update;
  EXPECT_EQ(folder.open(update).contents.models.size(), 10U);
  EXPECT_TRUE(update.rebuilt);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes_from_scratch(folder));

  folder.add("T9.off", "capsule", 9);  // same name, another shape
  make_old(folder);
  const std::string before = test::bytes_of(folder.index());
  folder.open();
  EXPECT_NE(test::bytes_of(folder.index()), before);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes_from_scratch(folder));

  std::filesystem::remove(folder.models() / "T9.off");
  std::filesystem::remove(folder.models() / "T0.off");
  EXPECT_EQ(folder.open().contents.models.size(), 8U);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes_from_scratch(folder));
}

TEST_F(OpenIndexOfAFolder, RecomputesNoModelsForANewModificationTime) {
  folder.open();
  make_old(folder);
  IndexUpdate update;
  folder.open(update);
  EXPECT_FALSE(update.rebuilt);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes_from_scratch(folder));
}

TEST_F(OpenIndexOfAFolder, ExcludesUnusableModelsAndReportsThemOnce) {
  test::write_text(folder.models() / "T5.off", "OFF\n3 1 0\n0 0 0\n");
  IndexUpdate first;
  const OpenIndex index = folder.open(first);
  ASSERT_EQ(first.left_out.size(), 1U);
  EXPECT_EQ(first.left_out.front().id, "T5.off");
  EXPECT_THAT(first.left_out.front().message, HasSubstr("T5.off"));
  EXPECT_THAT(ids_in(index),
              ElementsAre("T0.off", "T1.off", "T2.off", "T3.off", "T4.off", "T6.off", "T7.off", "T8.off"));
  IndexUpdate second;
  EXPECT_EQ(folder.open(second).contents.failures.size(), 1U);
  EXPECT_FALSE(second.rebuilt);
  EXPECT_THAT(second.left_out, IsEmpty());
  folder.add("T5.off", "box", 5);
  EXPECT_EQ(folder.open().contents.models.size(), 9U);
}

TEST_F(OpenIndexOfAFolder, RejectsACollectionWithoutValidModels) {
  for (int i = 0; i < 9; ++i) test::write_text(folder.models() / ("T" + std::to_string(i) + ".off"), "OFF\n");
  EXPECT_THAT(input_error_of([&] { folder.open(); }), HasSubstr("none of 9 models can be used; the first is T0.off"));
  EXPECT_FALSE(std::filesystem::exists(folder.index()));
}

TEST_F(OpenIndexOfAFolder, IsRebuiltIfDamagedOrOfAnotherMethod) {
  folder.open();
  const std::string bytes = test::bytes_of(folder.index());
  std::string damaged = bytes;
  damaged[damaged.size() / 2] ^= 1;
  for (const std::string& wrong :
       {std::string(), std::string("shapegauge search index 0\n"), bytes.substr(0, bytes.size() / 2), damaged}) {
    test::write_text(folder.index(), wrong);
    IndexUpdate update;
    folder.open(update);
    EXPECT_TRUE(update.rebuilt);
    EXPECT_THAT(update.notes, ElementsAre(HasSubstr("is damaged and is rebuilt")));
    EXPECT_EQ(test::bytes_of(folder.index()), bytes);
  }
  IndexUpdate update;
  folder.open(update, "d2");
  EXPECT_THAT(update.notes, ElementsAre(HasSubstr("of another method or program")));
}

TEST_F(OpenIndexOfAFolder, DoesNotOverwriteFilesThatAreNotIndexes) {
  Cache cache(folder.at("cache"));
  test::write_text(folder.at("notes.txt"), "index");
  for (const std::filesystem::path& file : {folder.at("notes.txt"), folder.models() / "T1.off"}) {
    const std::string before = test::bytes_of(file);
    IndexUpdate update;
    EXPECT_THAT(input_error_of([&] { open_index(folder.method(), folder.models(), file, {}, cache, update); }),
                HasSubstr(file.string() + " is not an index and is not overwritten"));
    EXPECT_EQ(test::bytes_of(file), before);
  }
}

TEST_F(OpenIndexOfAFolder, IsRejectedForAnotherCollectionButAcceptedForAMovedOne) {
  Cache cache(folder.at("cache"));
  folder.open();
  const std::string bytes = test::bytes_of(folder.index());
  const std::filesystem::path other = folder.at("other");
  std::filesystem::create_directory(other);
  write_off(other / "T0.off", test::small_shape("box", 40));  // the name alone does not make it the same file
  IndexUpdate update;
  const auto expected = testing::AllOf(HasSubstr(folder.models().filename().string() + ", none of whose files is in "),
                                       HasSubstr(other.string()), HasSubstr(folder.index().string()));
  EXPECT_THAT(input_error_of([&] { open_index(folder.method(), other, folder.index(), {}, cache, update); }), expected);
  EXPECT_THAT(input_error_of([&] { open_index_without_update(folder.method(), other, folder.index()); }), expected);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes);

  std::filesystem::remove_all(other);
  std::filesystem::rename(folder.models(), other);
  EXPECT_EQ(open_index_without_update(folder.method(), other, folder.index()).contents.models.size(), 9U);
  EXPECT_EQ(open_index(folder.method(), other, folder.index(), {}, cache, update).contents.models.size(), 9U);
  EXPECT_FALSE(update.rebuilt);
  for (int i = 0; i < 9; ++i) write_off(other / ("T" + std::to_string(i) + ".off"), test::small_shape("box", 20 + i));
  open_index(folder.method(), other, folder.index(), {}, cache, update);  // known by its path
  EXPECT_TRUE(update.rebuilt);
}

TEST_F(OpenIndexOfAFolder, CanBeReadWithoutUpdateAfterTheModelsAreDeleted) {
  folder.open();
  std::filesystem::remove_all(folder.models());
  EXPECT_EQ(open_index_without_update(folder.method(), folder.models(), folder.index()).contents.models.size(), 9U);
  EXPECT_THAT(input_error_of([&] { open_index_without_update(folder.method("d2"), folder.models(), folder.index()); }),
              HasSubstr("of another method or program"));
  test::write_text(folder.index(), "nothing");
  EXPECT_THAT(input_error_of([&] { open_index_without_update(folder.method(), folder.models(), folder.index()); }),
              HasSubstr("is damaged"));
}

TEST_F(OpenIndexOfAFolder, IsCompletedFromTheCacheAfterAnInterruption) {
  Cache cache(folder.at("cache"));
  std::atomic<int> asked = 0;
  const RunControl stops{.threads = 1, .interrupted = [&] { return ++asked > 6; }};
  IndexUpdate update;
  EXPECT_THROW(open_index(folder.method(), folder.models(), folder.index(), stops, cache, update), Interrupted);
  EXPECT_FALSE(std::filesystem::exists(folder.index()));
  const auto begun = cache.report().uses.at(static_cast<std::size_t>(EntryKind::field)).computed;
  EXPECT_GT(begun, 0U);
  Cache second(folder.at("cache"));
  open_index(folder.method(), folder.models(), folder.index(), {}, second, update);
  EXPECT_EQ(second.report().uses.at(static_cast<std::size_t>(EntryKind::field)).hits, begun);
  EXPECT_EQ(test::bytes_of(folder.index()), bytes_from_scratch(folder));
}

TEST_F(OpenIndexOfAFolder, StaysValidUnderConcurrentUpdates) {
  std::vector<std::thread> writers;
  for (int i = 0; i < 3; ++i) writers.emplace_back([&] { folder.open(); });
  for (std::thread& writer : writers) writer.join();
  IndexUpdate update;
  folder.open(update);
  EXPECT_FALSE(update.rebuilt);
  EXPECT_THAT(update.notes, IsEmpty());
}

TEST_F(OpenIndexOfAFolder, IsUsableIfItsFileCannotBeWritten) {
  Cache none;
  IndexUpdate update;
  const OpenIndex index = open_index(folder.method(), folder.models(), folder.at("absent") / "index", {}, none, update);
  EXPECT_EQ(index.contents.models.size(), 9U);
  EXPECT_THAT(update.notes, ElementsAre(HasSubstr("the index could not be written: cannot write")));
}

}  // namespace
}  // namespace shapegauge
