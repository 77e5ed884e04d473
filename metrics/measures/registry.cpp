#include "shapegauge/metrics/measures/registry.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "shapegauge/metrics/measures/area_under_curve.h"
#include "shapegauge/metrics/measures/average_precision.h"
#include "shapegauge/metrics/measures/bulls_eye.h"
#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"
#include "shapegauge/metrics/measures/e_measure.h"
#include "shapegauge/metrics/measures/f1_at.h"
#include "shapegauge/metrics/measures/first_tier.h"
#include "shapegauge/metrics/measures/nearest_neighbour.h"
#include "shapegauge/metrics/measures/normalised_discounted_gain.h"
#include "shapegauge/metrics/measures/precision_at.h"
#include "shapegauge/metrics/measures/r_precision.h"
#include "shapegauge/metrics/measures/recall_at.h"
#include "shapegauge/metrics/measures/reciprocal_rank.h"
#include "shapegauge/metrics/measures/second_tier.h"

namespace shapegauge {
namespace {

constexpr std::size_t largest_k = 1000000000;

[[noreturn]] void fail_unknown(std::string_view name) {
  std::string message = "there is no measure \"" + std::string(name.substr(0, 40)) + "\"; known are:";
  for (const MeasureDefinition& definition : measure_definitions()) message.append(" ").append(definition.name);
  throw std::invalid_argument(message);
}

std::size_t ranks_of(std::string_view name, std::string_view digits) {
  std::size_t k = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, k);
  if (error != std::errc() || stop != end || k == 0 || k > largest_k) {
    throw std::invalid_argument("the measure \"" + std::string(name.substr(0, 40)) +
                                "\" needs a number of ranks from 1 to 1000000000 after the @, as in " +
                                std::string(name.substr(0, name.find('@'))) + "@10");
  }
  return k;
}

}  // namespace

std::span<const MeasureDefinition> measure_definitions() {
  static constexpr std::array registered = {
      nearest_neighbour_definition,
      first_tier_definition,
      second_tier_definition,
      e_measure_definition,
      discounted_cumulative_gain_definition,
      average_precision_definition,
      precision_at_definition,
      recall_at_definition,
      f1_at_definition,
      reciprocal_rank_definition,
      normalised_discounted_gain_definition,
      r_precision_definition,
      area_under_curve_definition,
      bulls_eye_definition,
  };
  return registered;
}

Measure measure_of(std::string_view name) {
  if (name == "AP") name = average_precision_definition.name;
  const std::size_t at = name.find('@');
  const std::string wanted = at == std::string_view::npos ? std::string(name) : std::string(name.substr(0, at)) + "@k";
  const auto all = measure_definitions();
  const auto found = std::ranges::find(all, wanted, &MeasureDefinition::name);
  if (found == all.end()) fail_unknown(name);
  const std::size_t k = at == std::string_view::npos ? 0 : ranks_of(name, name.substr(at + 1));
  return {.name = std::string(name), .definition = &*found, .k = k};
}

std::vector<Measure> measures_of(std::span<const std::string> names) {
  std::vector<Measure> measures;
  measures.reserve(names.size());
  for (const std::string& name : names) {
    const Measure measure = measure_of(name);
    if (std::ranges::find(measures, measure.name, &Measure::name) != measures.end()) {
      throw std::invalid_argument("the measure \"" + measure.name + "\" is named twice");
    }
    measures.push_back(measure);
  }
  return measures;
}

std::vector<Measure> default_measures(Protocol protocol) {
  if (protocol == Protocol::trec) {
    return measures_of(std::vector<std::string>{"mAP", "P@10", "R@10", "MRR", "nDCG", "R-prec"});
  }
  return measures_of(std::vector<std::string>{"NN", "FT", "ST", "E", "DCG", "mAP"});
}

std::vector<Measure> default_measures(std::span<const Protocol> protocols) {
  std::vector<Measure> measures;
  for (const Protocol protocol : protocols) {
    for (const Measure& measure : default_measures(protocol)) {
      if (std::ranges::find(measures, measure.name, &Measure::name) == measures.end()) measures.push_back(measure);
    }
  }
  return measures;
}

}  // namespace shapegauge
