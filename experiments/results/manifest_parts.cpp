#include "shapegauge/experiments/results/manifest_parts.h"

#include "shapegauge/core/version.h"
#include "shapegauge/experiments/cache/processor.h"
#include "shapegauge/experiments/results/build_information.h"
#include "shapegauge/experiments/results/result_folder.h"
#include "shapegauge/experiments/results/sha256.h"

namespace shapegauge {

using Json = nlohmann::ordered_json;

Json program_json() {
  return {{"shapegauge", version()},
          {"commit", commit()},
          {"compiler", compiler()},
          {"build_type", build_type()},
          {"libraries", Json::parse(library_versions())},
          {"processor", processor()}};
}

Json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files) {
  Json hashes = Json::object();
  for (const std::string& file : files) {
    if (!holds_timings(file)) hashes[file] = sha256_of_file(folder / file);
  }
  return {{"algorithm", "SHA-256"}, {"files", std::move(hashes)}};
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
