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
  std::vector<double> dashes;  ///< lengths of dashes and gaps in points; empty for a solid line
  std::size_t sign = 0;        ///< symbol from 0 to 6: circle, square, triangle, diamond, cross, star, wye
};

MethodLook method_look(std::size_t index);

/// Draws the symbol of a method at a point of a drawing.
void draw_sign(Drawing& drawing, DrawingPoint place, const MethodLook& look);

/// Axis of a chart: its label, range of values and scale.
struct ChartAxis {
  std::string label = {};
  double low = 0;            ///< value at the beginning of the axis
  double high = 1;           ///< value at the end of the axis
  bool logarithmic = false;  ///< true for a logarithmic scale, whose ends must be above 0

  /// Maps a value to its relative position along the axis, from 0 to 1.
  [[nodiscard]] double part(double value) const;
};

/// Computes about `wanted` round tick values: multiples of 1, 2 or 5 times a power of ten. On a logarithmic axis of
/// more than a decade, the powers of ten, with 2 and 5 times these if there is room.
std::vector<double> axis_ticks(const ChartAxis& axis, std::size_t wanted = 6);

/// Formats tick values with the fewest digits, at least 4, whose rounding error is at most 1 % of the tick distance.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// Size of a chart in points; a column of most journals is 3.5 inches wide.
struct ChartSize {
  double width = 396;
  double height = 288;
};

/// Curve of a CurveChart: the name of a method and its points.
struct ChartCurve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< ordinates, one per abscissa in `x`
};

/// Chart of curves over common axes, with the methods' symbols, and a legend if there are several.
struct CurveChart {
  std::string title = {};  ///< title of the chart; may be empty
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartCurve> curves;
  ChartSize size = {};
};

Drawing draw_chart(const CurveChart& chart);

/// Bars of one method in a chart.
struct ChartBars {
  std::string name;
  std::vector<double> values;                                     ///< value of the bar in each group; NaN if missing
  std::vector<std::optional<ConfidenceInterval>> intervals = {};  ///< confidence interval per group; may be empty
};

/// Chart of horizontal bars: one row per group, one bar per method.
struct BarChart {
  std::string title = {};
  ChartAxis x;
  std::vector<std::string> groups;  ///< names of the groups
  std::vector<ChartBars> bars;
  double width = 396;  ///< width in points; the height follows from the number of bars
};

Drawing draw_chart(const BarChart& chart);

/// Histogram of a HistogramChart: the fraction of the surface area in each bin.
struct ChartHistogram {
  std::string name;
  std::vector<double> shares;  ///< fraction of the area in each bin, from 0 to 1; bins have equal widths
};

/// Chart of histograms over one axis: filled if there is one, otherwise as steps in the methods' colours.
struct HistogramChart {
  std::string title = {};
  ChartAxis x;
  std::string y_label = "share of the area (%)";
  std::vector<ChartHistogram> histograms;
  std::optional<double> mark = {};  ///< value marked by a vertical line; absent for none
  std::string mark_label = {};
  ChartSize size = {};
};

Drawing draw_chart(const HistogramChart& chart);

/// Colour map as a vertical bar with ticks and a heading, with its upper left corner at the origin.
struct ColourBar {
  ChartAxis axis;
  double height = 200;
  std::optional<double> below = {};  ///< threshold below which values have the colour `below_colour`
  Colour below_colour = {};
};

Drawing draw_chart(const ColourBar& bar);

}  // namespace shapegauge
