// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include "shapegauge/experiments/segmentation/segmentation_report.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;

/// Results of two methods on three shapes of class "a" and one of class "b"; the Rand errors of the first method are
/// 0.1, 0.3, 0.2 and 0.4.
SegmentationResults results() {
  SegmentationResults results;
  results.experiment.name = "hands";
  results.experiment.description = "of people";
  results.experiment.methods.resize(2);
  results.experiment.methods[0].name = "best";
  results.experiment.methods[1].name = "paper";
  SegmentationScores& scores = results.scores;
  scores.ids = {"1", "2", "3", "4"};
  scores.labels = {0, 0, 0, 1};
  scores.classes = {"a", "b"};
  scores.methods = {"best", "paper", people_name};
  scores.errors.resize(3);
  for (std::size_t m = 0; m < 3; ++m) {
    for (const double error : {0.1, 0.3, 0.2, 0.4}) {
      scores.errors[m].push_back({.rand_index = error / static_cast<double>(m + 1)});
    }
  }
  for (const std::string& id : scores.ids) {
    results.shapes.emplace_back();
    results.shapes.back().part_sizes = {{0.75, 0.25}, {1}};
    results.shapes.back().pictures = {"person " + id, "best " + id, "paper " + id};
  }
  results.failures.push_back({.id = "five", .message = "it is broken"});
  return results;
}

std::vector<std::string> titles(const std::vector<SegmentationFigure>& figures) {
  std::vector<std::string> all;
  for (const SegmentationFigure& figure : figures) all.push_back(figure.title);
  return all;
}

TEST(SegmentationReport, ShowsTheLargestErrorsFirstAndTheMedianShapeOfAClass) {
  const SegmentationResults shown = results();
  const SegmentationPage page = segmentation_report(shown);
  EXPECT_EQ(page.title, "hands");
  EXPECT_EQ(page.description, "of people");
  EXPECT_THAT(page.labels, ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(page.classes, ElementsAre("a", "b"));
  EXPECT_THAT(titles(page.shown), ElementsAre("4 (b)", "2 (a)", "3 (a)", "1 (a)"));
  EXPECT_THAT(page.typical, ElementsAre(2, 0));
  EXPECT_THAT(page.failures, ElementsAre(std::pair<std::string, std::string>("five", "it is broken")));
}

TEST(SegmentationReport, FigureShowsAHumanSegmentationAndEachMethodWithItsError) {
  const SegmentationResults shown = results();
  const SegmentationFigure figure = segmentation_report(shown).shown.front();
  ASSERT_EQ(figure.pictures.size(), 3U);
  EXPECT_EQ(figure.pictures[0].png, "person 4");
  EXPECT_EQ(figure.pictures[1].png, "best 4");
  EXPECT_EQ(figure.pictures[1].caption, "best: 0.400");
  EXPECT_EQ(figure.pictures[2].caption, "paper: 0.200");
}

TEST(SegmentationReport, HasTheMeanErrorOfEachMethodByClass) {
  const SegmentationResults shown = results();
  const SegmentationPage page = segmentation_report(shown);
  ASSERT_TRUE(page.errors);
  EXPECT_THAT(page.errors->methods, ElementsAre("best", "paper", people_name));
  ASSERT_EQ(page.errors->by_class.size(), 2U);
  EXPECT_DOUBLE_EQ(page.errors->by_class[0][0], 0.2);
  EXPECT_DOUBLE_EQ(page.errors->by_class[1][1], 0.2);
}

TEST(SegmentationReport, OmitsHumanSegmentationsAndPicturesIfThereAreNone) {
  SegmentationResults shown = results();
  shown.has_people = false;
  for (SegmentedShape& shape : shown.shapes) shape.pictures.erase(shape.pictures.begin());
  EXPECT_FALSE(segmentation_report(shown).errors);
  ASSERT_EQ(segmentation_report(shown).shown.front().pictures.size(), 2U);
  EXPECT_EQ(segmentation_report(shown).shown.front().pictures[0].caption, "best");
  shown.experiment.pictures = false;
  EXPECT_TRUE(segmentation_report(shown).shown.empty());
  EXPECT_TRUE(segmentation_report(shown).typical.empty());
}

}  // namespace
}  // namespace shapegauge
