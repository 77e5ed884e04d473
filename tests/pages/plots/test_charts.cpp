// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <limits>
#include <set>

#include "shapegauge/pages/palette.h"
#include "shapegauge/pages/plots/charts.h"

namespace shapegauge {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

std::set<std::string> texts_of(const Drawing& drawing) {
  std::set<std::string> texts;
  for (const auto& element : drawing.elements) {
    if (const auto* const text = std::get_if<DrawnText>(&element)) texts.insert(text->text);
  }
  return texts;
}

/// The unbroken or broken lines of that many points.
std::vector<DrawnPath> lines_of(const Drawing& drawing, std::size_t points) {
  std::vector<DrawnPath> lines;
  for (const auto& element : drawing.elements) {
    const auto* const path = std::get_if<DrawnPath>(&element);
    if (path != nullptr && path->points.size() == points && path->stroke && !path->closed) lines.push_back(*path);
  }
  return lines;
}

TEST(ChartAxis, TicksAreRoundNumbersWithinTheRange) {
  EXPECT_THAT(axis_ticks({.low = 0, .high = 1}, 5),
              ElementsAre(DoubleEq(0), DoubleEq(0.2), DoubleEq(0.4), DoubleEq(0.6), DoubleEq(0.8), DoubleEq(1)));
  EXPECT_THAT(axis_ticks({.low = 3.2, .high = 8.9}, 3), ElementsAre(DoubleEq(4), DoubleEq(6), DoubleEq(8)));
  EXPECT_THAT(axis_ticks({.low = 0.01, .high = 100, .logarithmic = true}),
              ElementsAre(DoubleEq(0.01), DoubleEq(0.1), DoubleEq(1), DoubleEq(10), DoubleEq(100)));
  EXPECT_THAT(axis_ticks({.low = 2, .high = 2}), ElementsAre(2));
}

TEST(ChartAxis, TickLabelsAreDistinct) {
  EXPECT_THAT(tick_labels({0, 0.05, 0.1}), ElementsAre("0", "0.05", "0.1"));
  EXPECT_THAT(tick_labels({1.9955, 1.996, 1.9965}), ElementsAre("1.9955", "1.996", "1.9965"));
  EXPECT_THAT(tick_labels({-1e-18, 20000, 40000}), ElementsAre("0", "2e+04", "4e+04"));
  EXPECT_THAT(tick_labels({1.0 / 3}), ElementsAre("0.3333"));
}

TEST(ChartAxis, MapsValuesLinearlyOrLogarithmically) {
  EXPECT_DOUBLE_EQ((ChartAxis{.low = 2, .high = 6}.part(3)), 0.25);
  EXPECT_DOUBLE_EQ((ChartAxis{.low = 1, .high = 10000, .logarithmic = true}.part(10)), 0.25);
}

TEST(MethodStyle, UsesReportColoursAndDiffersBetweenMethods) {
  EXPECT_EQ(method_look(0).colour, method_colour(0));
  EXPECT_THAT(method_look(0).dashes, ElementsAre());
  EXPECT_THAT(method_look(1).dashes, ElementsAre(7, 3));
  std::set<std::tuple<Colour, std::vector<double>>> looks;
  for (std::size_t i = 0; i < 21; ++i) looks.insert({method_look(i).colour, method_look(i).dashes});
  EXPECT_EQ(looks.size(), 21U);
}

TEST(CurveChart, DrawsEachCurveAtItsValues) {
  const Drawing drawing =
      draw_chart({.title = "Both",
                  .x = {.label = "Recall"},
                  .y = {.label = "Precision"},
                  .curves = {{"one", {0, 0.5, 1}, {1, 0.5, 0}}, {"other", {0, 0.5, 1}, {1, 1, 1}}}});
  const std::set<std::string> texts = texts_of(drawing);
  for (const char* text : {"Both", "Recall", "Precision", "one", "other", "0.2"})
    EXPECT_TRUE(texts.contains(text)) << text;
  const std::vector<DrawnPath> curves = lines_of(drawing, 3);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_DOUBLE_EQ(curves[0].points[1][0], (curves[0].points[0][0] + curves[0].points[2][0]) / 2);
  EXPECT_DOUBLE_EQ(curves[0].points[1][1], (curves[0].points[0][1] + curves[0].points[2][1]) / 2);
  EXPECT_DOUBLE_EQ(curves[1].points[2][1], curves[0].points[0][1]);
  EXPECT_LT(curves[0].points[0][1], curves[0].points[2][1]) << "1 is above 0, and y points down";
  EXPECT_LT(curves[0].points[0][0], curves[0].points[2][0]);
  EXPECT_NE(curves[0].stroke, curves[1].stroke);
}

TEST(BarChart, DrawsBarsInProportionToTheirValues) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Drawing drawing =
      draw_chart({.x = {.label = "nn (%)", .low = 0, .high = 100},
                  .groups = {"ants", "cups"},
                  .bars = {{"one", {100, 50}, {ConfidenceInterval{90, 100}, std::nullopt}}, {"other", {25, none}}}});
  std::vector<double> lengths;
  for (const auto& element : drawing.elements) {
    const auto* const path = std::get_if<DrawnPath>(&element);
    if (path != nullptr && path->fill && path->points[0][1] < 60)
      lengths.push_back(path->points[1][0] - path->points[0][0]);
  }
  ASSERT_EQ(lengths.size(), 3U);
  EXPECT_NEAR(lengths[1], lengths[0] / 4, 1e-9);
  EXPECT_NEAR(lengths[2], lengths[0] / 2, 1e-9);
  EXPECT_TRUE(texts_of(drawing).contains("cups"));
}

TEST(HistogramChart, MarksTheThresholdWithItsLabel) {
  const Drawing drawing = draw_chart({.x = {.label = "thickness (mm)", .low = 0, .high = 4},
                                      .histograms = {{"hand", {0.25, 0.75}}},
                                      .mark = 1,
                                      .mark_label = "2 % below 1 mm"});
  EXPECT_TRUE(texts_of(drawing).contains("2 % below 1 mm"));
  EXPECT_TRUE(texts_of(drawing).contains("80"));  // with room above the bars for the label
}

TEST(ColourBar, ShowsTheThresholdColourBelowTheThreshold) {
  const Drawing drawing = draw_chart(
      {.axis = {.label = "mm", .low = 0, .high = 4}, .height = 128, .below = 1.0, .below_colour = {255, 0, 0}});
  int red = 0;
  int all = 0;
  for (const auto& element : drawing.elements) {
    const auto* const path = std::get_if<DrawnPath>(&element);
    if (path == nullptr || !path->fill) continue;
    ++all;
    if (*path->fill == Colour{255, 0, 0}) ++red;
  }
  EXPECT_EQ(4 * red, all);
}

}  // namespace
}  // namespace shapegauge
