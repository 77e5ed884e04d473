#include "shapegauge/experiments/results/manifest_parts.h"

#include "shapegauge/core/version.h"
#include "shapegauge/experiments/results/build_information.h"

namespace shapegauge {

using Json = nlohmann::ordered_json;

Json program_json() {
  return {{"shapegauge", version()},
          {"commit", commit()},
          {"compiler", compiler()},
          {"build_type", build_type()},
          {"libraries", Json::parse(library_versions())}};
}

Json fields_json(std::span<const FieldReport> fields) {
  Json list = Json::array();
  for (const FieldReport& field : fields) list.push_back({{"field", field.settings}, {"samples", field.outcomes}});
  return list;
}

Json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                    std::span<const FieldReport> fields) {
  Json seconds = Json::object();
  for (const auto& [stage, time] : timings) seconds[stage] = time;
  Json by_field = Json::array();
  for (const FieldReport& field : fields) {
    by_field.push_back({{"field", field.settings}, {"seconds", field.seconds}});
  }
  return {{"threads", threads}, {"seconds", std::move(seconds)}, {"field_seconds", std::move(by_field)}};
}

}  // namespace shapegauge
