#include "shapegauge/experiments/configuration/chosen_offset.h"

#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/preparation/cavities.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

/// Rounds up to two digits, which keeps the gaps closed.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

/// Recommends a replacement for an offset smaller than the gaps of the shape.
std::string advice(const ChosenOffset& chosen) {
  const double enough = rounded_up(1.1 * chosen.gap);
  if (enough > 1) return "no offset closes them";
  const bool automatic_is_enough = !chosen.automatic && enough <= AutomaticOffsetOptions{}.most;
  return fmt::format("use `offset={:.2g}`{}", enough, automatic_is_enough ? " or `offset=auto`" : "");
}

}  // namespace

ChosenOffset chosen_automatically(const AutomaticOffset& automatic) {
  return {.offset = automatic.offset, .gap = automatic.widest_gap, .automatic = automatic};
}

ChosenOffset choose_offset(std::optional<double> given, const Shape& shape) {
  if (!given) return chosen_automatically(automatic_offset(shape));
  ChosenOffset chosen{.offset = *given, .automatic = {}};
  const double gap = gap_size(shape);
  if (gap > 0) chosen.gap = gap / bounding_box_diagonal(shape);
  return chosen;
}

bool leaves_gaps_open(const ChosenOffset& chosen) { return chosen.automatic && chosen.gap > chosen.automatic->gap; }

std::optional<std::string> leak_warning(const ChosenOffset& chosen) {
  if (chosen.offset >= chosen.gap) return std::nullopt;
  const bool stays_open = leaves_gaps_open(chosen);
  return fmt::format("the {} ({} % of the diagonal){}: the offset surface leaks into it; {}",
                     stays_open ? "widest gap of the shape" : "offset is smaller than the gaps of the shape",
                     two_digits(100 * chosen.gap), stays_open ? " stays open" : "", advice(chosen));
}

std::optional<std::string> hollow_remark(const Shape& shape, bool measures_hull) {
  const auto cavities = static_cast<std::int64_t>(cavity_count(shape));
  if (cavities == 0) return std::nullopt;
  return fmt::format(
      "the shape is hollow ({}): {}", count_text(cavities, "inner surface", "inner surfaces"),
      measures_hull ? "offset_sdf measures its hull, as if it were solid; inscribed_ball and cone_sdf measure its wall"
                    : "values are the thickness of its wall, not of the hull");
}

std::optional<std::string> two_sided_warning(const Shape& shape, const Eigen::VectorXd& values, double offset) {
  const Eigen::Index count = (values.array() < 0.5 * offset * bounding_box_diagonal(shape)).count();
  if (count == 0 || is_closed(shape)) return std::nullopt;
  return fmt::format(
      "{} of {} samples are about equally far from the outside on both sides; the direction of their normals depends "
      "on the input's orientation or on chance",
      count, values.size());
}

}  // namespace shapegauge
