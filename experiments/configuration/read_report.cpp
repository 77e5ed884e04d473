#include "shapegauge/experiments/configuration/read_report.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/experiments/configuration/misplaced_value.h"
#include "shapegauge/experiments/configuration/nearest_word.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

bool has_field(const SignatureConfiguration& signature) { return signature.field.has_value(); }

std::size_t signature_named(const std::string& name, const std::vector<SignatureConfiguration>& signatures) {
  const auto found = std::ranges::find(signatures, name, &SignatureConfiguration::name);
  if (found == signatures.end()) {
    std::vector<std::string> names;
    for (const SignatureConfiguration& signature : signatures) names.push_back(signature.name);
    throw MisplacedValue{"pictures.of", fmt::format("there is no signature \"{}\"{}", name, suggestion(name, names))};
  }
  if (!has_field(*found)) {
    throw MisplacedValue{"pictures.of",
                         fmt::format("the signature \"{}\" concatenates others: name one of them", name)};
  }
  return static_cast<std::size_t>(found - signatures.begin());
}

Interval picture_range(const Json& range) {
  const Interval interval{.low = range.at(0), .high = range.at(1)};
  if (interval.low < interval.high) return interval;
  throw MisplacedValue{"pictures.range",
                       fmt::format("the first value must be less than the second, not {}", range.dump())};
}

}  // namespace

ReportConfiguration read_report(const Json& setting, const std::vector<SignatureConfiguration>& signatures) {
  ReportConfiguration report;
  const auto first = std::ranges::find_if(signatures, has_field);
  report.pictured_signature = static_cast<std::size_t>(first - signatures.begin());
  if (setting.is_boolean()) report.wanted = setting;
  const Json pictures = setting.is_object() ? setting.value("pictures", Json(true)) : Json(report.wanted);
  report.pictures = pictures != Json(false);
  if (!pictures.is_object()) return report;
  if (pictures.contains("of")) report.pictured_signature = signature_named(pictures.at("of"), signatures);
  if (pictures.contains("range")) report.picture_options.range = picture_range(pictures.at("range"));
  return report;
}

}  // namespace shapegauge
