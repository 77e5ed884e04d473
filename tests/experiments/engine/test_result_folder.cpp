// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include "shapegauge/experiments/engine/result_folder.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(FileSafeName, ReplacesOnlyUnsafeCharacters) {
  EXPECT_EQ(file_safe_name("Our SDF (d = 1%)"), "Our_SDF_d_1");
  EXPECT_EQ(file_safe_name("v1.2-b"), "v1.2-b");
  EXPECT_EQ(file_safe_name("a/../b"), "a_.._b");
  EXPECT_EQ(file_safe_name("../x"), "x");
  EXPECT_EQ(file_safe_name(".."), "unnamed");
  EXPECT_EQ(file_safe_name("中文"), "unnamed");
  EXPECT_EQ(file_safe_name(std::string(300, 'a')).size(), 100U);
}

TEST(FileSafeNames, StayDifferentIfCaseIsIgnored) {
  const std::vector<std::string> names{"a b", "a/b", "A?b", "a_b_2"};
  EXPECT_THAT(file_safe_names(names), ElementsAre("a_b", "a_b_2", "A_b_3", "a_b_2_2"));
}

RC_GTEST_PROP(FileSafeName, IsNonEmptyAndHasNoLeadingDotOrPathSeparator, (const std::string& name)) {
  const std::string safe = file_safe_name(name);
  RC_ASSERT(!safe.empty());
  RC_ASSERT(safe.front() != '.');
  RC_ASSERT(safe.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
            std::string::npos);
}

std::string lock_error(const fs::path& folder) {
  return test::input_error_of([&] { const FolderLock lock(folder); });
}

TEST(FolderLock, RejectsASecondLockOfTheFolder) {
  const test::TemporaryFolder folder;
  {
    const FolderLock lock(folder.path() / "a/b");
    EXPECT_THAT(lock_error(folder.path() / "a/b"), HasSubstr("another run is writing to"));
    EXPECT_THAT(lock_error(folder.path() / "a/b"), HasSubstr("`output`"));
    EXPECT_EQ(lock_error(folder.path() / "a"), "no error");
    EXPECT_THAT(lock_error(folder.path() / "a/b"), HasSubstr("another run")) << "the refused one has not unlocked it";
  }
  EXPECT_TRUE(fs::is_empty(folder.path() / "a/b"));
  EXPECT_EQ(lock_error(folder.path() / "a/b"), "no error");
}

TEST(FolderLock, IgnoresTheLockFileOfAKilledRun) {
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / ".shapegauge-lock", "");
  EXPECT_EQ(lock_error(folder.path()), "no error");
}

TEST(FolderLock, RejectsAFolderWithoutWritePermission) {
  EXPECT_THAT(lock_error("/proc/x"), HasSubstr("/proc/x"));
  EXPECT_THAT(lock_error("/proc"), HasSubstr("cannot write to the folder /proc"));
}

const nlohmann::json mine{{"name", "mine"}};

std::string error_for(const fs::path& folder, bool replace = false) {
  return test::input_error_of([&] { prepare_result_folder(folder, mine, replace); });
}

using ResultFolder = test::FolderTest;

TEST_F(ResultFolder, IsCreatedWithItsParents) {
  EXPECT_EQ(error_for(at("a/b")), "no error");
  EXPECT_TRUE(fs::is_empty(at("a/b")));
}

TEST_F(ResultFolder, AcceptsAFolderWithUnrelatedFiles) {
  write_text(at("notes.txt"), "x");
  EXPECT_EQ(error_for(folder_.path()), "no error");
}

TEST_F(ResultFolder, CanBeReusedByTheSameConfiguration) {
  write_text(at("manifest.json"), R"({"configuration": {"name": "mine"}})");
  EXPECT_EQ(error_for(folder_.path()), "no error");
}

TEST_F(ResultFolder, KeepsResultsOfAnotherConfigurationUnlessForced) {
  for (const std::string manifest : {R"({"configuration": {"name": "other"}})", "[]", "{"}) {
    const test::TemporaryFolder folder;
    write_text(at("manifest.json"), manifest);
    EXPECT_THAT(error_for(folder_.path()), HasSubstr("results of another configuration")) << manifest;
    EXPECT_EQ(error_for(folder_.path(), true), "no error");
  }
  write_text(at("summary.csv"), "method\n");
  EXPECT_THAT(error_for(folder_.path()), HasSubstr("`replace=true`"));
}

TEST_F(ResultFolder, RejectsUnwritableFolders) {
  write_text(at("x"), "a file");
  EXPECT_THAT(error_for(at("x")), HasSubstr("cannot create the "));
  EXPECT_THAT(error_for(at("x/y")), HasSubstr("cannot create the "));
  EXPECT_THAT(error_for("/proc/results"), HasSubstr("cannot"));
}

/// Folder with results of an earlier run and a file of the user.
class StagedResultsInAFolder : public test::FolderTest {
 protected:
  void SetUp() override {
    write_text(at("summary.csv"), "old");
    write_text(at("distances/a.npy"), "old");
    write_text(at("distances/b.npy"), "old");
    write_text(at("notes.txt"), "mine");
    write_text(at("manifest.json"), R"({"files": ["summary.csv", "distances/a.npy", "distances/b.npy"]})");
  }
};

TEST_F(StagedResultsInAFolder, ReplaceEarlierResultsWhenPublished) {
  {
    StagedResults staged(folder_.path());
    write_text(staged.folder() / "summary.csv", "new");
    write_text(staged.folder() / "distances/a.npy", "new");
    write_text(staged.folder() / "manifest.json", "{}");
    EXPECT_EQ(text_of(at("summary.csv")), "old");
    staged.publish({"summary.csv", "distances/a.npy"});
  }
  EXPECT_EQ(text_of(at("summary.csv")), "new");
  EXPECT_EQ(text_of(at("distances/a.npy")), "new");
  EXPECT_EQ(text_of(at("manifest.json")), "{}");
  EXPECT_FALSE(fs::exists(at("distances/b.npy"))) << "of the earlier run only";
  EXPECT_EQ(text_of(at("notes.txt")), "mine");
  EXPECT_EQ(folder_.size(), 4U) << "nothing else: notes, manifest, summary, distances";
}

TEST_F(StagedResultsInAFolder, MustNotReplaceAnInputThatAnEarlierRunWrote) {
  const fs::path superseded = at("distances/b.npy");
  EXPECT_THROW(check_results_are_no_inputs(folder_.path(), {}, {&superseded, 1}), InputError);
  const fs::path folder_of_results = at("distances");
  EXPECT_THROW(check_results_are_no_inputs(folder_.path(), {}, {&folder_of_results, 1}), InputError);
  const fs::path of_the_user = at("notes.txt");
  EXPECT_NO_THROW(check_results_are_no_inputs(folder_.path(), {}, {&of_the_user, 1}));
}

TEST_F(StagedResultsInAFolder, DoNotRemoveUnrelatedFilesListedByAManifest) {
  const test::TemporaryFolder elsewhere;
  const fs::path neighbour = folder_.path().parent_path() / (folder_.path().filename().string() + "-neighbour.csv");
  const std::string outside = (elsewhere.path() / "summary.csv").string();
  write_text(neighbour, "not ours");
  write_text(outside, "not ours");
  write_text(at("data.npy"), "mine");
  write_text(at("parts/a.npy"), "mine");
  write_text(at("manifest.json"), nlohmann::json{{"files",
                                                  {"notes.txt", "../" + neighbour.filename().string(), outside,
                                                   "distances/../data.npy", "distances/../parts/a.npy", "data.npy",
                                                   "./summary.csv", "parts/a.npy", "distances", "", "summary.csv"}}}
                                      .dump());
  {
    StagedResults staged(folder_.path());
    write_text(staged.folder() / "manifest.json", "{}");
    staged.publish({});
  }
  EXPECT_FALSE(fs::exists(at("summary.csv"))) << "what a run writes is removed";
  EXPECT_EQ(text_of(at("notes.txt")), "mine");
  EXPECT_EQ(text_of(at("data.npy")), "mine");
  EXPECT_EQ(text_of(at("parts/a.npy")), "mine");
  EXPECT_EQ(text_of(at("distances/a.npy")), "old");
  EXPECT_EQ(text_of(neighbour), "not ours");
  EXPECT_EQ(text_of(outside), "not ours");
  fs::remove(neighbour);
}

TEST_F(StagedResultsInAFolder, LeaveEarlierResultsUnchangedUnlessPublished) {
  {
    const StagedResults staged(folder_.path());
    write_text(staged.folder() / "summary.csv", "new");
  }
  EXPECT_EQ(text_of(at("summary.csv")), "old");
  EXPECT_FALSE(fs::exists(at(".shapegauge-new")));
}

TEST_F(StagedResultsInAFolder, RemoveTemporaryFilesOfAKilledRun) {
  write_text(at(".shapegauge-new/per_class.csv"), "half");
  {
    const StagedResults staged(folder_.path());
    EXPECT_TRUE(fs::is_empty(staged.folder()));
  }
  EXPECT_FALSE(fs::exists(at(".shapegauge-new")));
}

TEST_F(StagedResultsInAFolder, ReportAFileThatCannotBeMoved) {
  fs::remove(at("summary.csv"));
  write_text(at("summary.csv/x"), "a folder of that name");
  StagedResults staged(folder_.path());
  write_text(staged.folder() / "summary.csv", "new");
  EXPECT_THAT(test::input_error_of([&] { staged.publish({"summary.csv"}); }), testing::HasSubstr("cannot write"));
}

}  // namespace

}  // namespace shapegauge
