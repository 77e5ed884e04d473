#include "shapegauge/experiments/configuration/read_signatures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/experiments/configuration/misplaced_value.h"
#include "shapegauge/experiments/configuration/nearest_word.h"
#include "shapegauge/experiments/fields/field_registry.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

HistogramConfiguration histogram_of(const Json& settings) {
  HistogramConfiguration histogram;
  histogram.options.bins = settings.value("bins", histogram.options.bins);
  histogram.options.smoothing_bins = settings.value("smoothing_bins", histogram.options.smoothing_bins);
  if (histogram.options.smoothing_bins > histogram.options.bins) {
    throw MisplacedValue{"smoothing_bins", fmt::format("the smoothing must be at most the number of bins ({}), not {}",
                                                       histogram.options.bins, histogram.options.smoothing_bins)};
  }
  const Json& range = settings.at("range");
  if (range.is_object()) {
    histogram.range = HistogramRange::fixed;
    histogram.fixed = {.low = range.at("fixed").at(0), .high = range.at("fixed").at(1)};
    if (!(histogram.fixed.low < histogram.fixed.high)) {
      throw MisplacedValue{
          "range.fixed", fmt::format("the first value must be less than the second, not {}", range.at("fixed").dump())};
    }
    if (!std::isfinite(histogram.fixed.high - histogram.fixed.low)) {
      throw MisplacedValue{"range.fixed", fmt::format("the values are too far apart: {}", range.at("fixed").dump())};
    }
  } else {
    histogram.range = range == "dataset" ? HistogramRange::dataset : HistogramRange::per_shape;
  }
  return histogram;
}

std::vector<std::string> unique_names(const Json& signatures) {
  std::vector<std::string> names;
  for (const Json& signature : signatures) {
    const std::string name = signature.at("name");
    const auto earlier = std::ranges::find(names, name);
    if (earlier != names.end()) {
      throw MisplacedValue{fmt::format("{}.name", names.size()),
                           fmt::format("\"{}\" is the name of signatures.{} already", name, earlier - names.begin())};
    }
    names.push_back(name);
  }
  return names;
}

std::vector<std::size_t> parts_of(const Json& concatenate, const std::vector<std::string>& names) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < concatenate.size(); ++i) {
    const std::string name = concatenate[i];
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
      throw MisplacedValue{fmt::format("concatenate.{}", i),
                           fmt::format("there is no signature \"{}\"{}", name, suggestion(name, names))};
    }
    parts.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return parts;
}

SignatureConfiguration signature_of(const Json& settings, const std::vector<std::string>& names) {
  SignatureConfiguration signature;
  signature.name = settings.at("name");
  if (settings.contains("concatenate")) {
    for (const char* key : {"field", "histogram"}) {
      if (settings.contains(key)) throw MisplacedValue{key, "does not go with \"concatenate\"; remove one of the two"};
    }
    signature.parts = parts_of(settings.at("concatenate"), names);
    return signature;
  }
  signature.field = at("field", [&] { return make_field(settings.at("field")); });
  signature.histogram = at("histogram", [&] { return histogram_of(settings.at("histogram")); });
  return signature;
}

}  // namespace

std::vector<SignatureConfiguration> read_signatures(const Json& settings) {
  const std::vector<std::string> names = unique_names(settings);
  std::vector<SignatureConfiguration> signatures;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    signatures.push_back(at(std::to_string(i), [&] { return signature_of(settings[i], names); }));
  }
  if (const auto cyclic = part_of_itself(signatures)) {
    throw MisplacedValue{fmt::format("{}.concatenate", *cyclic),
                         fmt::format("the signature \"{}\" is a part of itself", names[*cyclic])};
  }
  return signatures;
}

}  // namespace shapegauge
