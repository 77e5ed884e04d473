// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/pages/plots/drawing.h"

namespace shapegauge {

/// Colour, dashes and symbol of a method, as in the reports (pages/report/method_look.mjs).
struct MethodLook {
  Colour colour;
  std::vector<double> dashes;
  std::size_t sign = 0;  ///< symbol: circle, square, triangle, diamond, cross, star, wye
};

MethodLook method_look(std::size_t index);

/// Draws the symbol of a method at a point.
void draw_sign(Drawing& drawing, DrawingPoint place, const MethodLook& look);

/// Axis of a chart.
struct ChartAxis {
  std::string label = {};
  double low = 0;
  double high = 1;
  bool logarithmic = false;  ///< both ends must be above 0

  /// Maps a value to its relative position along the axis, from 0 to 1.
  [[nodiscard]] double part(double value) const;
};

/// Computes about `wanted` round tick values: multiples of 1, 2 or 5 times a power of ten. On a logarithmic axis of
/// more than a decade, the powers of ten, with 2 and 5 times these if there is room.
std::vector<double> axis_ticks(const ChartAxis& axis, std::size_t wanted = 6);

/// Formats the ticks of an axis with as many digits as needed, at least 4, to round by 1 % of their distance at most.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// Size of a chart in points; a column of most journals is 3.5 inches wide.
struct ChartSize {
  double width = 396;
  double height = 288;
};

/// Line of a chart of curves.
struct ChartCurve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< as many as x
};

/// Chart of curves over common axes, with the methods' symbols, and a legend if there are several.
struct CurveChart {
  std::string title = {};  ///< may be empty
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartCurve> curves;
  ChartSize size = {};
};

Drawing draw_chart(const CurveChart& chart);

/// Bars of one method in a chart.
struct ChartBars {
  std::string name;
  std::vector<double> values;                                     ///< one a group; NaN if missing
  std::vector<std::optional<ConfidenceInterval>> intervals = {};  ///< one a group, or empty
};

/// Chart of horizontal bars: one row per group, one bar per method.
struct BarChart {
  std::string title = {};
  ChartAxis x;
  std::vector<std::string> groups;
  std::vector<ChartBars> bars;
  double width = 396;  ///< the height follows from the number of bars
};

Drawing draw_chart(const BarChart& chart);

/// Histogram of a chart: shares of the area by bin.
struct ChartHistogram {
  std::string name;
  std::vector<double> shares;  ///< one a bin, of equal widths along the axis
};

/// Chart of histograms over one axis: filled if there is one, otherwise as steps in the methods' colours.
struct HistogramChart {
  std::string title = {};
  ChartAxis x;
  std::string y_label = "share of the area (%)";
  std::vector<ChartHistogram> histograms;
  std::optional<double> mark = {};  ///< value marked by a vertical line
  std::string mark_label = {};
  ChartSize size = {};
};

Drawing draw_chart(const HistogramChart& chart);

/// Colour map as a vertical bar with ticks and a heading, with its upper left corner at the origin.
struct ColourBar {
  ChartAxis axis;
  double height = 200;
  std::optional<double> below = {};  ///< smaller values have the colour `below_colour`
  Colour below_colour = {};
};

Drawing draw_chart(const ColourBar& bar);

}  // namespace shapegauge
