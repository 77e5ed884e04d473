// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/chosen_offset.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/preparation/cavities.h"
#include "shapegauge/core/preparation/gap_size.h"

namespace shapegauge {

namespace {

/// Rounds up to two digits, which keeps the gaps closed.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

/// Recommends a remedy for gaps wider than the offset.
std::string advice(const ChosenOffset& chosen) {
  constexpr double max_advised = 0.2;  // beyond it, little of the shape is left
  const double enough = rounded_up(offset_per_gap * chosen.gap);
  if (enough > max_advised) return "no small offset closes it: fill it, or measure more points of a cloud";
  const bool automatic_is_enough = !chosen.automatic && enough <= largest_automatic_offset;
  return fmt::format("use `offset={:.2g}`{}", enough, automatic_is_enough ? " or `offset=auto`" : "");
}

}  // namespace

ChosenOffset chosen_automatically(const AutomaticOffset& automatic) {
  return {.offset = automatic.offset, .gap = automatic.widest_gap, .automatic = automatic};
}

ChosenOffset choose_offset(std::optional<double> fixed, const Shape& shape) {
  if (!fixed) return chosen_automatically(automatic_offset(shape));
  ChosenOffset chosen{.offset = *fixed, .automatic = {}};
  const double gap = gap_sizes(shape).widest;
  if (gap > 0) chosen.gap = gap / bounding_box_diagonal(shape);
  return chosen;
}

std::optional<double> fixed_offset(const FieldSettings& field) {
  const ParameterValue* const value = field.values.find("offset");
  const auto* const offset = value == nullptr ? nullptr : std::get_if<double>(value);
  return offset == nullptr ? std::nullopt : std::optional(*offset);
}

std::optional<ChosenOffset> offset_of(const FieldSettings& field, FieldSource& source) {
  if (field.values.find("offset") == nullptr) return std::nullopt;
  const std::optional<double> fixed = fixed_offset(field);
  return fixed ? choose_offset(fixed, source.shape()) : chosen_automatically(source.automatic_offset());
}

std::string reasons_for_offset(const ChosenOffset& chosen) {
  if (!chosen.automatic) return {};
  const auto& [offset, gap, widest_gap, noise, sufficient] = *chosen.automatic;
  std::vector<std::string> reasons;
  if (gap > offset) {
    reasons.push_back(fmt::format("closing the gaps would take {:.4g} %", 100 * gap));
  } else if (gap > 0) {
    reasons.push_back(fmt::format("{:.4g} % closes the {}gaps", 100 * gap,
                                  offset_per_gap * widest_gap > largest_automatic_offset ? "narrower " : ""));
  }
  if (noise > offset) {
    reasons.push_back(fmt::format("smoothing the noise would take {:.4g} %", 100 * noise));
  } else if (noise > 0) {
    reasons.push_back(fmt::format("{:.4g} % smooths the noise", 100 * noise));
  }
  if (!reasons.empty()) return fmt::format("{}", fmt::join(reasons, ", "));
  return widest_gap > 0 ? "no noise, and gaps too wide to close" : "no gaps or noise found";
}

std::optional<std::string> leak_warning(const ChosenOffset& chosen) {
  if (chosen.offset >= chosen.gap) return std::nullopt;
  const bool stays_open = chosen.automatic.has_value();
  return fmt::format("the {} ({} % of the diagonal){}: the offset surface leaks into it; {}",
                     stays_open ? "widest gap of the shape" : "offset is smaller than the gaps of the shape",
                     two_digits(100 * chosen.gap), stays_open ? " stays open" : "", advice(chosen));
}

std::optional<std::string> hollow_remark(const Shape& shape, bool measures_hull) {
  const auto cavities = static_cast<std::int64_t>(closed_components(shape).cavities);
  if (cavities == 0) return std::nullopt;
  return fmt::format(
      "the shape is hollow ({}): {}", count_text(cavities, "inner surface", "inner surfaces"),
      measures_hull ? "offset_sdf measures its hull, as if it were solid; inscribed_ball and cone_sdf measure its wall"
                    : "values are the thickness of its wall, not of the hull");
}

}  // namespace shapegauge
