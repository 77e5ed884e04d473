// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <gmock/gmock.h>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "shapegauge/experiments/engine/part.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Environment without variables of launchers, except for the given ones.
class AutomaticPart : public testing::Test {
 protected:
  void SetUp() override { clear(); }
  void TearDown() override { clear(); }

  static std::string part_with(const std::map<std::string, std::string>& variables) {
    clear();
    for (const auto& [name, value] : variables) ::setenv(name.c_str(), value.c_str(), 1);
    const Part part = parse_part("auto");
    return std::to_string(part.number) + "/" + std::to_string(part.count);
  }
  static void clear() {
    for (const char* name :
         {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
          "SLURM_ARRAY_TASK_STEP", "SLURM_PROCID", "SLURM_NTASKS", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}) {
      ::unsetenv(name);
    }
  }
};

TEST(RunPart, AllPartsTogetherCoverEachItemOnce) {
  std::vector<std::size_t> items;
  for (std::size_t i = 0; i < 11; ++i) items.push_back(2 * i);
  for (const std::size_t count : {1U, 2U, 3U, 11U, 20U}) {
    std::multiset<std::size_t> all;
    for (std::size_t number = 1; number <= count; ++number) {
      for (const std::size_t item : Part{.number = number, .count = count}.of(items)) all.insert(item);
    }
    EXPECT_TRUE(std::ranges::equal(all, items)) << count;
  }
  EXPECT_THAT((Part{.number = 2, .count = 4}.of(items)), ElementsAre(2, 10, 18));
}

TEST(RunPart, IsParsedFromNumberAndCountSeparatedByASlash) {
  const Part part = parse_part("3/64");
  EXPECT_EQ(part.number, 3U);
  EXPECT_EQ(part.count, 64U);
  for (const char* text : {"", "3", "0/4", "5/4", "1/0", "-1/4", "1/4/2", "1 /4", "a/b", "1/99999999999999999999999"}) {
    EXPECT_THAT(test::input_error_of([&] { (void)parse_part(text); }), HasSubstr("K/N")) << text;
  }
}

TEST_F(AutomaticPart, IsReadFromEnvironmentVariablesOfJobLaunchers) {
  EXPECT_EQ(part_with({{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "8"}, {"SLURM_ARRAY_TASK_MIN", "1"}}),
            "3/8");
  EXPECT_EQ(part_with({{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "8"}, {"SLURM_ARRAY_TASK_MIN", "0"}}),
            "4/8");
  EXPECT_EQ(part_with({{"SLURM_ARRAY_TASK_ID", "8"},
                       {"SLURM_ARRAY_TASK_COUNT", "3"},
                       {"SLURM_ARRAY_TASK_MIN", "0"},
                       {"SLURM_ARRAY_TASK_STEP", "4"}}),
            "3/3");
  EXPECT_EQ(part_with({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "2"}}), "1/2");
  EXPECT_EQ(part_with({{"SLURM_PROCID", "5"}, {"SLURM_NTASKS", "6"}}), "6/6");
}

TEST_F(AutomaticPart, UsesTheInnermostOfSeveralJobLaunchers) {
  EXPECT_EQ(
      part_with(
          {{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "4"}, {"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "1"}}),
      "4/4")
      << "mpirun under Slurm";
  EXPECT_EQ(part_with({{"SLURM_ARRAY_TASK_ID", "2"},
                       {"SLURM_ARRAY_TASK_COUNT", "2"},
                       {"SLURM_ARRAY_TASK_MIN", "1"},
                       {"SLURM_PROCID", "0"},
                       {"SLURM_NTASKS", "1"}}),
            "2/2")
      << "a job array";
}

/// With --array=1,3,7, two tasks would have the first part of three, and none the second.
TEST_F(AutomaticPart, RejectsUnevenlySpacedJobArrayTasks) {
  std::map<std::string, std::string> task{{"SLURM_ARRAY_TASK_ID", "7"},
                                          {"SLURM_ARRAY_TASK_COUNT", "3"},
                                          {"SLURM_ARRAY_TASK_MIN", "1"},
                                          {"SLURM_ARRAY_TASK_MAX", "7"},
                                          {"SLURM_ARRAY_TASK_STEP", "2"}};
  EXPECT_THAT(test::input_error_of([&] { (void)part_with(task); }), HasSubstr("K/N"));
  task["SLURM_ARRAY_TASK_STEP"] = "3";
  EXPECT_EQ(part_with(task), "3/3");
}

TEST_F(AutomaticPart, IsRejectedWithoutAJobLauncher) {
  EXPECT_THAT(test::input_error_of([&] { (void)parse_part("auto"); }), HasSubstr("SLURM_ARRAY_TASK_ID"));
  EXPECT_THAT(test::input_error_of([&] {
                (void)part_with({{"SLURM_PROCID", "1"}, {"SLURM_NTASKS", "x"}});
              }),
              HasSubstr("K/N"));
}

}  // namespace

}  // namespace shapegauge
