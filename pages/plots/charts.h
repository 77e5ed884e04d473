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
  Colour colour;               ///< colour of the method's line, bar and symbol
  std::vector<double> dashes;  ///< lengths of dashes and gaps in points; empty for a solid line
  std::size_t sign = 0;        ///< index of the symbol, 0 to 6: circle, square, triangle, diamond, cross, star, wye
};

MethodLook method_look(std::size_t index);  ///< returns colour, dashes and symbol of the method with this index

/// Adds the symbol of a method (MethodLook::sign) to a drawing, centred at `centre`.
void draw_symbol(Drawing& drawing, DrawingPoint centre, const MethodLook& look);

/// Axis of a chart: its label, range of values and scale.
struct ChartAxis {
  std::string label = {};    ///< text at the axis
  double low = 0;            ///< value at the beginning of the axis
  double high = 1;           ///< value at the end of the axis
  bool logarithmic = false;  ///< true for a logarithmic scale, whose ends must be above 0

  /// Returns the relative position of a value along the axis: 0 at `low`, 1 at `high`.
  [[nodiscard]] double part(double value) const;
};

/// Returns about `target_count` round values for the ticks of an axis: multiples of 1, 2 or 5 times a power of ten. On
/// a logarithmic axis of more than a decade, the powers of ten, with 2 and 5 times these if there is room.
std::vector<double> axis_ticks(const ChartAxis& axis, std::size_t target_count = 6);

/// Formats tick values with the fewest significant digits, at least 4, whose rounding error is at most 1 % of the
/// distance between ticks.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// Size of a chart in points; a column of most journals is 3.5 inches wide.
struct ChartSize {
  double width = 396;   ///< width in points
  double height = 288;  ///< height in points
};

/// Curve of a CurveChart: the name of a method and its points.
struct ChartCurve {
  std::string name;       ///< name of the method, for the legend
  std::vector<double> x;  ///< x coordinates of the points, in values of the x axis
  std::vector<double> y;  ///< y coordinates of the points, in values of the y axis
};

/// Chart of curves over common axes, with the methods' symbols, and a legend if there are several.
struct CurveChart {
  std::string title = {};          ///< title of the chart; empty for none
  ChartAxis x;                     ///< horizontal axis
  ChartAxis y;                     ///< vertical axis
  std::vector<ChartCurve> curves;  ///< curves, one per method
  ChartSize size = {};             ///< size of the whole chart
};

Drawing draw_chart(const CurveChart& chart);  ///< draws the chart with axes and legend

/// Bars of one method in a BarChart.
struct ChartBars {
  std::string name;                                               ///< name of the method
  std::vector<double> values;                                     ///< value of the bar in each group; NaN if missing
  std::vector<std::optional<ConfidenceInterval>> intervals = {};  ///< confidence interval per group; empty for none
};

/// Chart of horizontal bars: one row per group, one bar per method.
struct BarChart {
  std::string title = {};           ///< title of the chart; empty for none
  ChartAxis x;                      ///< horizontal axis, along which bars extend
  std::vector<std::string> groups;  ///< names of the groups, such as classes or measures
  std::vector<ChartBars> bars;      ///< bars, one entry per method
  double width = 396;               ///< width in points; the height follows from the number of bars
};

Drawing draw_chart(const BarChart& chart);  ///< draws bars with axis and legend

/// Histogram of a HistogramChart: the fraction of the surface area in each bin.
struct ChartHistogram {
  std::string name;            ///< name for the legend
  std::vector<double> shares;  ///< fraction of the area in each bin, from 0 to 1; bins have equal widths
};

/// Chart of histograms over one axis: filled if there is one, otherwise as steps in the methods' colours.
struct HistogramChart {
  std::string title = {};                         ///< title of the chart; empty for none
  ChartAxis x;                                    ///< horizontal axis, whose range the bins divide equally
  std::string y_label = "share of the area (%)";  ///< text at the y axis
  std::vector<ChartHistogram> histograms;
  std::optional<double> mark = {};  ///< value on the x axis with a vertical line; absent for none
  std::string mark_label = {};      ///< text next to the vertical line
  ChartSize size = {};
};

Drawing draw_chart(const HistogramChart& chart);  ///< draws histograms with axes and legend

/// Colour map as a vertical bar with ticks and a heading, with its upper left corner at the origin.
struct ColourBar {
  ChartAxis axis;                    ///< heading, range of values and scale of the bar
  double height = 200;               ///< height of the bar in points
  std::optional<double> below = {};  ///< threshold below which values have `below_colour`; absent for none
  Colour below_colour = {};          ///< colour of values below the threshold
};

Drawing draw_chart(const ColourBar& bar);  ///< draws a colour bar with ticks

}  // namespace shapegauge
