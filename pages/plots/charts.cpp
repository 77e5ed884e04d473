// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/plots/charts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <sstream>

#include "shapegauge/core/base/text.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

constexpr double font_size = 10;
constexpr double title_size = 12;

/// Area of a chart between its axes.
struct ChartFrame {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;

  [[nodiscard]] double x(const ChartAxis& axis, double value) const { return left + width * axis.part(value); }
  [[nodiscard]] double y(const ChartAxis& axis, double value) const { return top + height * (1 - axis.part(value)); }
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
};

Colour ink() { return page_colour("ink"); }

void draw_title(Drawing& drawing, const std::string& title) {
  if (title.empty()) return;
  drawing.text({.text = title,
                .position = {drawing.width / 2, 16},
                .size = title_size,
                .colour = ink(),
                .anchor = TextAnchor::middle,
                .bold = true});
}

double top_margin(const std::string& title) { return title.empty() ? 10 : 26; }

/// Returns the width of the widest text.
double widest(const std::vector<std::string>& texts) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, estimated_text_width(text, font_size));
  return width;
}

void draw_x_axis(Drawing& drawing, const ChartFrame& frame, const ChartAxis& axis, bool grid) {
  const std::vector<double> ticks = axis_ticks(axis);
  const std::vector<std::string> labels = tick_labels(ticks);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double x = frame.x(axis, ticks[i]);
    if (grid) drawing.line({x, frame.top}, {x, frame.bottom()}, page_colour("grid"), 0.7);
    drawing.line({x, frame.bottom()}, {x, frame.bottom() + 4}, ink(), 0.8);
    drawing.text({.text = labels[i],
                  .position = {x, frame.bottom() + 15},
                  .size = font_size,
                  .colour = ink(),
                  .anchor = TextAnchor::middle});
  }
  drawing.line({frame.left, frame.bottom()}, {frame.right(), frame.bottom()}, ink(), 0.8);
  drawing.text({.text = axis.label,
                .position = {frame.left + frame.width / 2, frame.bottom() + 31},
                .colour = ink(),
                .anchor = TextAnchor::middle});
}

void draw_y_axis(Drawing& drawing, const ChartFrame& frame, const ChartAxis& axis) {
  const std::vector<double> ticks = axis_ticks(axis);
  const std::vector<std::string> labels = tick_labels(ticks);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double y = frame.y(axis, ticks[i]);
    drawing.line({frame.left, y}, {frame.right(), y}, page_colour("grid"), 0.7);
    drawing.line({frame.left - 4, y}, {frame.left, y}, ink(), 0.8);
    drawing.text({.text = labels[i],
                  .position = {frame.left - 7, y + 3.5},
                  .size = font_size,
                  .colour = ink(),
                  .anchor = TextAnchor::end});
  }
  drawing.line({frame.left, frame.top}, {frame.left, frame.bottom()}, ink(), 0.8);
  drawing.text({.text = axis.label,
                .position = {13, frame.top + frame.height / 2},
                .colour = ink(),
                .anchor = TextAnchor::middle,
                .upwards = true});
}

/// Legend: names of methods with their lines, in as many columns as fit.
class Legend {
 public:
  Legend(std::vector<std::string> names, double width) : names_(std::move(names)) {
    column_width_ = widest(names_) + swatch + 16;
    columns_ = std::clamp(static_cast<std::size_t>(width / column_width_), std::size_t{1},
                          std::max<std::size_t>(1, names_.size()));
  }

  [[nodiscard]] double height() const {
    if (names_.size() < 2) return 0;
    const std::size_t rows = (names_.size() + columns_ - 1) / columns_;
    return row_height * static_cast<double>(rows) + 8;
  }

  void draw(Drawing& drawing, double left, double top, bool with_lines) const {
    if (names_.size() < 2) return;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const MethodLook look = method_look(i);
      const double x = left + column_width_ * static_cast<double>(i % columns_);
      const std::size_t row = i / columns_;
      const double y = top + row_height * static_cast<double>(row) + 9;
      if (with_lines) {
        drawing.path({.points = {{x, y - 3.5}, {x + swatch, y - 3.5}},
                      .stroke = look.colour,
                      .width = 1.4,
                      .dashes = look.dashes});
        draw_symbol(drawing, {x + swatch / 2, y - 3.5}, look);
      } else {
        drawing.rectangle({x + swatch / 2 - 5, y - 8}, {10, 9}, look.colour);
      }
      drawing.text({.text = names_[i], .position = {x + swatch + 5, y}, .size = font_size, .colour = ink()});
    }
  }

 private:
  static constexpr double swatch = 28;
  static constexpr double row_height = 14;

  std::vector<std::string> names_;
  double column_width_ = 0;
  std::size_t columns_ = 1;
};

template <typename Series>
std::vector<std::string> names_of(const std::vector<Series>& series) {
  std::vector<std::string> names;
  for (const Series& one : series) names.push_back(one.name);
  return names;
}

/// Computes the frame of a chart with an axis on its left and the legend below.
ChartFrame frame_of(Drawing& drawing, const std::string& title, const ChartAxis& y, const Legend& legend) {
  ChartFrame frame;
  frame.left = 26 + widest(tick_labels(axis_ticks(y)));
  frame.top = top_margin(title);
  frame.width = drawing.width - frame.left - 14;
  frame.height = drawing.height - frame.top - 38;
  drawing.height += legend.height();
  draw_title(drawing, title);
  return frame;
}

double nice_step(double range, std::size_t target_count) {
  const double rough = range / static_cast<double>(target_count);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power * (1 + 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<double> decade_ticks(const ChartAxis& axis, std::size_t target_count) {
  const std::vector<double> few{1};
  const std::vector<double> many{1, 2, 5};
  const double decades = std::log10(axis.high / axis.low);
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(axis.low))); power <= std::ceil(std::log10(axis.high));
       ++power) {
    for (const double factor : 3 * decades <= static_cast<double>(target_count) + 1 ? many : few) {
      const double tick = factor * std::pow(10, power);
      if (tick >= axis.low * (1 - 1e-9) && tick <= axis.high * (1 + 1e-9)) ticks.push_back(tick);
    }
  }
  return ticks;
}

constexpr double bar_height = 9;

/// Draws the bar of one series in one group, with its interval if any, from y downwards.
void draw_bar(Drawing& drawing, const ChartFrame& frame, const BarChart& chart, std::size_t series, std::size_t group,
              double y) {
  const ChartBars& bars = chart.bars[series];
  const double value = bars.values[group];
  if (std::isnan(value)) return;
  const double from = frame.x(chart.x, std::max(0.0, chart.x.low));
  drawing.rectangle({from, y}, {frame.x(chart.x, value) - from, bar_height - 1}, method_look(series).colour);
  if (group >= bars.intervals.size() || !bars.intervals[group]) return;
  const ConfidenceInterval& interval = *bars.intervals[group];
  const double middle = y + (bar_height - 1) / 2;
  drawing.line({frame.x(chart.x, interval.low), middle}, {frame.x(chart.x, interval.high), middle}, ink(), 0.9);
  for (const double end : {interval.low, interval.high}) {
    drawing.line({frame.x(chart.x, end), middle - 2.5}, {frame.x(chart.x, end), middle + 2.5}, ink(), 0.9);
  }
}

/// Returns the outline of a histogram's bars, from the axis to the axis.
std::vector<DrawingPoint> step_line(const ChartFrame& frame, const ChartAxis& y, const std::vector<double>& shares) {
  std::vector<DrawingPoint> points{{frame.left, frame.bottom()}};
  for (std::size_t bin = 0; bin < shares.size(); ++bin) {
    const double top = frame.y(y, 100 * shares[bin]);
    for (const std::size_t edge : {bin, bin + 1}) {
      points.push_back(
          {frame.left + frame.width * static_cast<double>(edge) / static_cast<double>(shares.size()), top});
    }
  }
  points.push_back({frame.right(), frame.bottom()});
  return points;
}

/// Draws the mark of a histogram as a dashed line with its label.
void draw_mark(Drawing& drawing, const ChartFrame& frame, const HistogramChart& chart) {
  const double x = std::clamp(frame.x(chart.x, *chart.mark), frame.left, frame.right());
  drawing.path({.points = {{x, frame.top}, {x, frame.bottom()}},
                .stroke = page_colour("wrong"),
                .width = 1.2,
                .dashes = {4, 2}});
  const bool at_right = x > frame.left + frame.width / 2;
  drawing.text({.text = chart.mark_label,
                .position = {x + (at_right ? -4 : 4), frame.top + 10},
                .size = font_size,
                .colour = page_colour("wrong"),
                .anchor = at_right ? TextAnchor::end : TextAnchor::start});
}

}  // namespace

MethodLook method_look(std::size_t index) {
  MethodLook look{.colour = method_colour(index), .dashes = {}, .sign = dash_or_symbol_index(index, 7)};
  const std::string_view dashes = method_dashes[dash_or_symbol_index(index, method_dashes.size())];
  if (dashes == "none") return look;
  std::istringstream lengths{std::string(dashes)};
  for (double length = 0; lengths >> length;) look.dashes.push_back(length);
  return look;
}

void draw_symbol(Drawing& drawing, DrawingPoint centre, const MethodLook& look) {
  constexpr double size = 3;
  const auto polygon = [&](int corners, double first, double inner) {
    DrawnPath path{.points = {}, .closed = true, .fill = look.colour};
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / corners + first;
      const double radius = k % 2 == 1 ? inner : size;
      path.points.push_back({centre[0] + radius * std::sin(angle), centre[1] - radius * std::cos(angle)});
    }
    drawing.path(std::move(path));
  };
  const auto cross = [&](int arms) {
    for (int k = 0; k < arms; ++k) {
      const double angle = 2 * std::numbers::pi * k / arms;
      drawing.line(centre, {centre[0] + 1.3 * size * std::sin(angle), centre[1] - 1.3 * size * std::cos(angle)},
                   look.colour, 1.8);
    }
  };
  switch (look.sign) {
    case 0:
      return polygon(24, 0, size);
    case 1:
      return polygon(4, std::numbers::pi / 4, size);
    case 2:
      return polygon(3, 0, size);
    case 3:
      return polygon(4, 0, size);
    case 4:
      return cross(4);
    case 5:
      return polygon(10, 0, 0.45 * size);
    default:
      return cross(3);
  }
}

double ChartAxis::part(double value) const {
  if (!(high > low)) return 0.5;
  if (logarithmic) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

std::vector<double> axis_ticks(const ChartAxis& axis, std::size_t target_count) {
  if (!(axis.high > axis.low) || !std::isfinite(axis.high - axis.low)) return {axis.low};
  if (axis.logarithmic && axis.high > 10 * axis.low) return decade_ticks(axis, target_count);
  const double step = nice_step(axis.high - axis.low, target_count);
  std::vector<double> ticks;
  for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; ++k)
    ticks.push_back(k * step);
  return ticks;
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < ticks.size(); ++i) distance = std::min(distance, std::abs(ticks[i] - ticks[i - 1]));
  const auto is_exact = [&](int digits) {
    return std::ranges::all_of(ticks, [&](double tick) {
      return std::abs(parse_number(fmt::format("{:.{}g}", tick, digits)).value_or(tick) - tick) <= distance / 100;
    });
  };
  int digits = 4;
  while (digits < 15 && !is_exact(digits)) ++digits;
  std::vector<std::string> labels;
  for (const double tick : ticks) {
    const bool is_zero = std::abs(tick) < std::max(1e-300, std::isfinite(distance) ? distance / 1e6 : 0);
    labels.push_back(is_zero ? "0" : fmt::format("{:.{}g}", tick, digits));
  }
  return labels;
}

Drawing draw_chart(const CurveChart& chart) {
  Drawing drawing{.width = chart.size.width, .height = chart.size.height, .elements = {}};
  const Legend legend(names_of(chart.curves), drawing.width - 20);
  const ChartFrame frame = frame_of(drawing, chart.title, chart.y, legend);
  draw_y_axis(drawing, frame, chart.y);
  draw_x_axis(drawing, frame, chart.x, true);
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const MethodLook look = method_look(i);
    DrawnPath path{.points = {}, .stroke = look.colour, .width = 1.4, .dashes = look.dashes};
    for (std::size_t k = 0; k < chart.curves[i].x.size(); ++k) {
      path.points.push_back({frame.x(chart.x, chart.curves[i].x[k]), frame.y(chart.y, chart.curves[i].y[k])});
    }
    const std::vector<DrawingPoint> points = path.points;
    drawing.path(std::move(path));
    if (points.size() > 40) continue;  // signs would hide the line
    for (const DrawingPoint& point : points) draw_symbol(drawing, point, look);
  }
  legend.draw(drawing, 12, chart.size.height, true);
  return drawing;
}

Drawing draw_chart(const BarChart& chart) {
  constexpr double gap = 8;
  const double group_height = bar_height * static_cast<double>(std::max<std::size_t>(1, chart.bars.size()));
  const Legend legend(names_of(chart.bars), chart.width - 20);
  ChartFrame frame;
  frame.left = std::min(0.4 * chart.width, widest(chart.groups) + 14);
  frame.top = top_margin(chart.title);
  frame.width = chart.width - frame.left - 14;
  frame.height = (group_height + gap) * static_cast<double>(chart.groups.size()) + gap;
  Drawing drawing{.width = chart.width, .height = frame.bottom() + 38 + legend.height(), .elements = {}};
  draw_title(drawing, chart.title);
  draw_x_axis(drawing, frame, chart.x, true);
  for (std::size_t group = 0; group < chart.groups.size(); ++group) {
    const double top = frame.top + gap + (group_height + gap) * static_cast<double>(group);
    drawing.text({.text = chart.groups[group],
                  .position = {frame.left - 6, top + group_height / 2 + 3.5},
                  .size = font_size,
                  .colour = ink(),
                  .anchor = TextAnchor::end});
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
      draw_bar(drawing, frame, chart, i, group, top + bar_height * static_cast<double>(i));
    }
  }
  drawing.line({frame.left, frame.top}, {frame.left, frame.bottom()}, ink(), 0.8);
  legend.draw(drawing, 12, frame.bottom() + 38, false);
  return drawing;
}

Drawing draw_chart(const HistogramChart& chart) {
  double largest = 0;
  for (const ChartHistogram& one : chart.histograms) {
    for (const double share : one.shares) largest = std::max(largest, 100 * share);
  }
  ChartAxis y{.label = chart.y_label, .low = 0, .high = largest > 0 ? (chart.mark ? 1.12 : 1) * largest : 1};
  y.high = std::ceil(y.high / nice_step(y.high, 6) - 1e-9) * nice_step(y.high, 6);
  Drawing drawing{.width = chart.size.width, .height = chart.size.height, .elements = {}};
  const Legend legend(names_of(chart.histograms), drawing.width - 20);
  const ChartFrame frame = frame_of(drawing, chart.title, y, legend);
  draw_y_axis(drawing, frame, y);
  for (std::size_t i = 0; i < chart.histograms.size(); ++i) {
    const MethodLook look = method_look(i);
    DrawnPath steps{.points = step_line(frame, y, chart.histograms[i].shares), .width = 1.4, .dashes = look.dashes};
    (chart.histograms.size() == 1 ? steps.fill : steps.stroke) = look.colour;
    drawing.path(std::move(steps));
  }
  draw_x_axis(drawing, frame, chart.x, false);
  if (chart.mark) draw_mark(drawing, frame, chart);
  legend.draw(drawing, 12, chart.size.height, false);
  return drawing;
}

Drawing draw_chart(const ColourBar& bar) {
  constexpr int steps = 128;
  constexpr double width = 14;
  constexpr double top = 22;
  const std::vector<double> ticks = axis_ticks(bar.axis);
  const std::vector<std::string> labels = tick_labels(ticks);
  const double room = std::max(width + 10 + widest(labels), estimated_text_width(bar.axis.label, font_size));
  Drawing drawing{.width = room + 8, .height = bar.height + top + 8, .elements = {}};
  drawing.text({.text = bar.axis.label, .position = {0, 10}, .size = font_size, .colour = ink()});
  for (int k = 0; k < steps; ++k) {
    // Steps overlap to avoid visible seams.
    const double from = bar.height * (1 - (k + 1.0) / steps);
    const double part = (k + 0.5) / steps;
    const double value = bar.axis.logarithmic ? bar.axis.low * std::pow(bar.axis.high / bar.axis.low, part)
                                              : bar.axis.low + part * (bar.axis.high - bar.axis.low);
    const Colour colour = bar.below && value < *bar.below ? bar.below_colour : colour_of(part);
    drawing.rectangle({0, top + from}, {width, std::min(bar.height - from, 2 * bar.height / steps)}, colour);
  }
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double y = top + bar.height * (1 - bar.axis.part(ticks[i]));
    drawing.line({width, y}, {width + 4, y}, ink(), 0.8);
    drawing.text({.text = labels[i], .position = {width + 7, y + 3.5}, .size = font_size, .colour = ink()});
  }
  return drawing;
}

}  // namespace shapegauge
