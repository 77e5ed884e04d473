#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/pages/plots/drawing.h"

namespace shapegauge {

/// Colour, dashes and sign of the i-th of several methods: those of the reports (pages/report/method_look.mjs).
struct MethodLook {
  Colour colour;
  std::vector<double> dashes;
  std::size_t sign = 0;  ///< circle, square, triangle, diamond, cross, star, wye
};

MethodLook method_look(std::size_t index);

/// Draws the sign of a method about a place.
void draw_sign(Drawing& drawing, DrawingPoint place, const MethodLook& look);

/// An axis of a chart.
struct ChartAxis {
  std::string label = {};
  double low = 0;
  double high = 1;
  bool logarithmic = false;  ///< both ends must be above 0

  /// Where a value is along the axis, from 0 to 1.
  [[nodiscard]] double part(double value) const;
};

/// Round values on an axis, about as many as wanted: multiples of 1, 2 or 5 times a power of ten, or of a logarithmic
/// axis of more than a decade the powers of ten, 2 and 5 times these where there is room.
std::vector<double> axis_ticks(const ChartAxis& axis, std::size_t wanted = 6);

/// The number in the digits that tell the ticks of an axis apart.
std::string tick_label(double value);

/// Size of a chart in points; 3.5 inches are a column of most journals.
struct ChartSize {
  double width = 396;
  double height = 288;
};

/// A line of a chart of curves.
struct ChartCurve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< as many
};

/// Curves over common axes, with the methods' signs, and a legend where there are several.
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
  std::vector<double> values;                                     ///< one a group; NaN: none
  std::vector<std::optional<ConfidenceInterval>> intervals = {};  ///< one a group, or none at all
};

/// Groups of bars that run to the right, a row a group, a bar a method.
struct BarChart {
  std::string title = {};
  ChartAxis x;
  std::vector<std::string> groups;
  std::vector<ChartBars> bars;
  double width = 396;  ///< the height follows from the number of bars
};

Drawing draw_chart(const BarChart& chart);

/// A histogram of a chart: shares of the area by bins.
struct ChartHistogram {
  std::string name;
  std::vector<double> shares;  ///< one a bin; bins are of equal width along the axis
};

/// Histograms over one axis: filled where there is one, else as steps in the methods' colours.
struct HistogramChart {
  std::string title = {};
  ChartAxis x;
  std::string y_label = "share of the area (%)";
  std::vector<ChartHistogram> histograms;
  std::optional<double> mark = {};  ///< a value to be marked by a vertical line
  std::string mark_label = {};
  ChartSize size = {};
};

Drawing draw_chart(const HistogramChart& chart);

/// A colour map as a vertical bar with ticks and a heading, its upper left corner at the origin.
struct ColourBar {
  ChartAxis axis;
  double height = 200;
  std::optional<double> below = {};  ///< values below it have the colour `below_colour`
  Colour below_colour = {};
};

Drawing draw_chart(const ColourBar& bar);

}  // namespace shapegauge
