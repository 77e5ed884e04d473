#include <gmock/gmock.h>

#include "shapegauge/experiments/results/staged_results.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {
namespace {

namespace fs = std::filesystem;
using test_experiments::text_of;
using test_experiments::write_text;

/// A folder with the results of an earlier run and a file of the user's.
class StagedResultsTest : public testing::Test {
 protected:
  void SetUp() override {
    write_text(at("summary.csv"), "old");
    write_text(at("distances/a.npy"), "old");
    write_text(at("distances/b.npy"), "old");
    write_text(at("notes.txt"), "mine");
    write_text(at("manifest.json"), R"({"files": ["summary.csv", "distances/a.npy", "distances/b.npy"]})");
  }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }

  test_io::TemporaryFolder folder_;
};

TEST_F(StagedResultsTest, TakeThePlaceOfEarlierOnes) {
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

TEST_F(StagedResultsTest, LeaveTheEarlierOnesWhereTheyAreNotPublished) {
  {
    const StagedResults staged(folder_.path());
    write_text(staged.folder() / "summary.csv", "new");
  }
  EXPECT_EQ(text_of(at("summary.csv")), "old");
  EXPECT_FALSE(fs::exists(at(".shapegauge-new")));
}

TEST_F(StagedResultsTest, WhatAKilledRunHasLeftIsRemoved) {
  write_text(at(".shapegauge-new/per_class.csv"), "half");
  {
    const StagedResults staged(folder_.path());
    EXPECT_TRUE(fs::is_empty(staged.folder()));
  }
  EXPECT_FALSE(fs::exists(at(".shapegauge-new")));
}

TEST_F(StagedResultsTest, AFileThatCannotBeMovedIsAnError) {
  fs::remove(at("summary.csv"));
  write_text(at("summary.csv/x"), "a folder of that name");
  StagedResults staged(folder_.path());
  write_text(staged.folder() / "summary.csv", "new");
  EXPECT_THAT(input_error_of([&] { staged.publish({"summary.csv"}); }), testing::HasSubstr("cannot write"));
}

}  // namespace
}  // namespace shapegauge
