#include "shapegauge/experiments/engine/manifest.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/engine/build_information.h"
#include "shapegauge/experiments/engine/result_folder.h"

namespace shapegauge {

using OrderedJson = nlohmann::ordered_json;

OrderedJson program_json() {
  return {{"shapegauge", version()},
          {"commit", commit()},
          {"compiler", compiler()},
          {"build_type", build_type()},
          {"libraries", OrderedJson::parse(library_versions())},
          {"processor", processor()}};
}

OrderedJson outputs_json(const std::filesystem::path& folder, std::span<const std::string> files) {
  OrderedJson hashes = OrderedJson::object();
  for (const std::string& file : files) {
    if (!holds_timings(file)) hashes[file] = sha256_of_file(folder / file);
  }
  return {{"algorithm", "SHA-256"}, {"files", std::move(hashes)}};
}

}  // namespace shapegauge
