// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/experiments/evaluation/segmentation_tables.h"
#include "shapegauge/segmentation/seg_file.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Scores of a method and of people on four meshes of two classes; a third class has none.
SegmentationScores small_scores() {
  const auto errors = [](double rand, double cut) {
    SegmentationErrors all;
    all.rand_index = rand;
    all.hamming = rand / 2;
    all.missing_rate = rand / 4;
    all.false_alarm_rate = 3 * rand / 4;
    all.cut_discrepancy = cut;
    return all;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {.ids = {"1", "2", "3", "4"},
          .labels = {0, 1, 0, 0},
          .classes = {"cup", "ant", "bust"},
          .methods = {"mine", "people"},
          .errors = {{errors(0.1, 0.5), errors(0.25, 0.25), errors(0.3, nan), errors(0.65, 0)},
                     {errors(0.2, 1), errors(0.5, 0.5), errors(0.2, 0.25), errors(0.5, 0.25)}}};
}

TEST(SegmentationTables, AverageErrorsOverAClassOrAllShapesIgnoringUndefinedErrors) {
  const SegmentationScores scores = small_scores();
  EXPECT_DOUBLE_EQ(scores.mean(0, &SegmentationErrors::rand_index), 1.3 / 4);
  EXPECT_DOUBLE_EQ(scores.mean(0, &SegmentationErrors::rand_index, 0), 1.05 / 3);
  EXPECT_DOUBLE_EQ(scores.mean(0, &SegmentationErrors::rand_index, 1), 0.25);
  EXPECT_DOUBLE_EQ(scores.mean(1, &SegmentationErrors::hamming, 0), 0.15);
  EXPECT_DOUBLE_EQ(scores.mean(0, &SegmentationErrors::cut_discrepancy), 0.25) << "three of four";
  EXPECT_DOUBLE_EQ(scores.mean(0, &SegmentationErrors::cut_discrepancy, 0), 0.25) << "two of three";
  EXPECT_TRUE(std::isnan(scores.mean(0, &SegmentationErrors::rand_index, 2)));
}

/// Index of the column of an error.
std::size_t column_of(const TextTable& table, double SegmentationErrors::*value) {
  for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
    if (entry.value != value) continue;
    for (std::size_t k = 0; k < table.header.size(); ++k) {
      if (table.header[k] == entry.name) return k;
    }
  }
  return table.header.size();
}

TEST(SegmentationTables, ContainTheMeansOfEachMethodAndClass) {
  const SegmentationScores scores = small_scores();
  const TextTable means = mean_table(scores);
  ASSERT_EQ(means.rows.size(), 2U);
  EXPECT_EQ(means.rows[0].at(column_of(means, &SegmentationErrors::rand_index)), "0.3250");
  EXPECT_EQ(means.rows[0].at(column_of(means, &SegmentationErrors::cut_discrepancy)), "0.2500");
  EXPECT_EQ(means.rows[1].at(column_of(means, &SegmentationErrors::false_alarm_rate)), "0.2625");
  const TextTable classes = class_table(scores);
  EXPECT_EQ(classes.rows, (std::vector<std::vector<std::string>>{
                              {"cup", "0.3500", "0.3000"}, {"ant", "0.2500", "0.5000"}, {"bust", "-", "-"}}));
  const TextTable all = class_error_table(scores);
  ASSERT_EQ(all.rows.size(), 6U);
  EXPECT_EQ(all.rows[4][0], "people");
  EXPECT_EQ(all.rows[4][1], "ant");
  EXPECT_EQ(all.rows[4].at(column_of(all, &SegmentationErrors::missing_rate)), "0.125");
  EXPECT_EQ(all.rows[2].at(column_of(all, &SegmentationErrors::rand_index)), "") << "a class without meshes";
  const TextTable meshes = mesh_table(scores);
  ASSERT_EQ(meshes.rows.size(), 8U);
  EXPECT_EQ((std::vector<std::string>{meshes.rows[2][0], meshes.rows[2][1], meshes.rows[2][2]}),
            (std::vector<std::string>{"mine", "3", "cup"}));
  EXPECT_EQ(meshes.rows[2].at(column_of(meshes, &SegmentationErrors::rand_index)), "0.3");
  EXPECT_EQ(meshes.rows[2].at(column_of(meshes, &SegmentationErrors::cut_discrepancy)), "") << "undefined";
  for (const TextTable* table : {&means, &classes, &all, &meshes}) {
    for (const auto& row : table->rows) EXPECT_EQ(row.size(), table->header.size());
  }
}

TEST(SegmentationTables, CompareMethodsByTheirMeanErrorsPerClass) {
  SegmentationScores scores = small_scores();
  const std::optional<MethodComparison> comparison = rand_comparison(scores);
  ASSERT_TRUE(comparison);
  EXPECT_NEAR(comparison->averages[0], (0.35 + 0.25) / 2, 1e-12);
  EXPECT_NEAR(comparison->averages[1], (0.3 + 0.5) / 2, 1e-12);
  const TextTable intervals = interval_table(scores, *comparison);
  ASSERT_EQ(intervals.rows.size(), 2U);
  EXPECT_EQ(intervals.rows[0][1], "0.3000");
  EXPECT_EQ(intervals.rows[1][1], "0.4000");
  const TextTable pairs = pair_table(scores, *comparison);
  ASSERT_EQ(pairs.rows.size(), 1U);
  EXPECT_EQ(pairs.rows[0][0], "mine");
  EXPECT_EQ(pairs.rows[0][1], "people");
  EXPECT_EQ(pairs.rows[0][2], "-0.1000");
  EXPECT_EQ(pairs.rows[0].back(), "1 of 3") << "ants; a class without meshes counts for nobody";
  scores.errors[0][1].rand_index = 0.5;
  EXPECT_EQ(pair_table(scores, *comparison).rows[0].back(), "0 of 3") << "nobody wins the ants";
}

TEST(SegmentationTables, OmitTheMethodComparisonForUndefinedErrorsOrOneClass) {
  SegmentationScores scores = small_scores();
  scores.errors[1][2].rand_index = std::nan("");
  EXPECT_FALSE(rand_comparison(scores)) << "an undefined error";
  scores = small_scores();
  scores.classes.resize(1);
  scores.labels.assign(4, 0);
  EXPECT_FALSE(rand_comparison(scores)) << "one class";
  scores = small_scores();
  scores.methods.pop_back();
  scores.errors.pop_back();
  EXPECT_FALSE(rand_comparison(scores)) << "one method";
}

/// A benchmark of three meshes with segmentations at random by two or three people, and two methods.
class SegmentationScoresOfAFolder : public test::FolderTest {
 protected:
  void SetUp() override {
    RandomNumbers random(1);
    for (int i = 0; i < 3; ++i) {
      const std::string id = std::to_string(20 * i + 1);
      const Shape mesh = test::box({1, 2, 3}, 1 + i);
      std::filesystem::create_directories(at("off"));
      write_off(at("off/" + id + ".off"), mesh);
      const auto segmentation = [&](const std::string& path, std::uint64_t segments) {
        std::vector<std::int32_t> labels;
        for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
          labels.push_back(static_cast<std::int32_t>(random.below(segments)));
        }
        std::filesystem::create_directories(at(path).parent_path());
        write_seg(at(path), labels);
        return labels;
      };
      for (int k = 0; k < 2 + i % 2; ++k) {
        people_[i].push_back(segmentation("seg/" + id + "/" + id + "_" + std::to_string(k) + ".seg", 4));
      }
      mine_[i] = segmentation("mine/" + id + ".seg", 3);
      theirs_[i] = segmentation("theirs/" + id + ".seg", 6);
    }
  }

  [[nodiscard]] SegmentationScores scores() const {
    return score_segmentations(find_segmentation_benchmark(folder_.path()), {at("mine"), at("theirs/")},
                               {.cuts = false});
  }
  std::array<std::vector<std::vector<std::int32_t>>, 3> people_;
  std::array<std::vector<std::int32_t>, 3> mine_, theirs_;
};

TEST_F(SegmentationScoresOfAFolder, AreMeanErrorsAgainstAndAmongHumanSegmentations) {
  const SegmentationScores found = scores();
  EXPECT_EQ(found.methods, (std::vector<std::string>{"mine", "theirs", people_name}));
  EXPECT_EQ(found.ids, (std::vector<std::string>{"1", "21", "41"}));
  for (std::size_t i = 0; i < 3; ++i) {
    for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
      if (entry.value == &SegmentationErrors::cut_discrepancy) continue;
      const auto mean = [&](const std::vector<SegmentationErrors>& all) {
        double sum = 0;
        for (const SegmentationErrors& one : all) sum += one.*entry.value;
        return sum / static_cast<double>(all.size());
      };
      std::vector<SegmentationErrors> of_mine;
      std::vector<SegmentationErrors> of_theirs;
      std::vector<SegmentationErrors> among;
      for (std::size_t k = 0; k < people_[i].size(); ++k) {
        of_mine.push_back(segmentation_errors(mine_[i], people_[i][k]));
        of_theirs.push_back(segmentation_errors(theirs_[i], people_[i][k]));
        for (std::size_t other = 0; other < people_[i].size(); ++other) {
          if (other != k) among.push_back(segmentation_errors(people_[i][k], people_[i][other]));
        }
      }
      EXPECT_NEAR(found.errors[0][i].*entry.value, mean(of_mine), 1e-12) << entry.name;
      EXPECT_NEAR(found.errors[1][i].*entry.value, mean(of_theirs), 1e-12) << entry.name;
      // Missing and false alarm rates exchange their roles with the segmentations; all others are symmetric.
      EXPECT_NEAR(found.errors[2][i].*entry.value, mean(among), 1e-12) << entry.name;
    }
  }
}

TEST_F(SegmentationScoresOfAFolder, ReportTheFirstInvalidSegmentation) {
  test::write_text(at("mine/41.seg"), "x\n");
  std::filesystem::remove(at("theirs/21.seg"));
  EXPECT_NE(test::input_error_of([&] { static_cast<void>(scores()); }).find("21.seg"), std::string::npos);
}

}  // namespace
}  // namespace shapegauge
