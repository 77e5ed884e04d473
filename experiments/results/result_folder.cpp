#include "shapegauge/experiments/results/result_folder.h"

#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/experiments/configuration/parse_json.h"
#include "shapegauge/experiments/results/write_results.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// The configuration in the manifest of the run whose results the folder holds; null where that cannot be told.
nlohmann::json earlier_configuration(const fs::path& folder) {
  try {
    const nlohmann::json manifest = read_json(folder / "manifest.json");
    return manifest.is_object() ? manifest.value("configuration", nlohmann::json()) : nlohmann::json();
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

void prepare_result_folder(const fs::path& folder, const nlohmann::json& configuration, bool force) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder)) {
    throw InputError(fmt::format("cannot make the folder {} for the results: {}", folder.string(),
                                 failure ? failure.message() : "there is a file of that name"));
  }
  // Writing is tried now: it must not be found out after hours.
  const fs::path probe = folder / ".shapegauge-probe";
  write_file_atomically(probe, "");
  fs::remove(probe, failure);

  if (force || !has_results(folder) || earlier_configuration(folder) == configuration) return;
  throw InputError(fmt::format(
      "{} holds the results of another configuration; give another folder with --output, or replace them with --force",
      folder.string()));
}

}  // namespace shapegauge
