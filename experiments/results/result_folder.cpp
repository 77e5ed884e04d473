#include "shapegauge/experiments/results/result_folder.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/experiments/configuration/parse_json.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// What runs write, retrieval experiments first; comparisons after them.
constexpr std::array<std::string_view, 17> result_names{
    "summary.csv",   "summary.json",  "summary.md",  "summary.tex", "intervals.csv", "per_class.csv",
    "per_query.csv", "pr_curves.csv", report_name,   "shapes.csv",  "distances",     "shape_seconds.csv",
    "distances.csv", "errors.csv",    "normals.csv", "timings.csv", "histograms.csv"};

/// Whether runs write files of that name, relative to the folder.
bool is_result(const fs::path& file) {
  if (file.parent_path() == "distances") return file.extension() == ".npy";
  return std::ranges::find(result_names, file.string()) != result_names.end();
}

/// The configuration in the manifest of the run whose results the folder holds; null where that cannot be told.
nlohmann::json earlier_configuration(const fs::path& folder) {
  try {
    const nlohmann::json manifest = read_json(folder / manifest_name);
    return manifest.is_object() ? manifest.value("configuration", nlohmann::json()) : nlohmann::json();
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

bool holds_timings(std::string_view file) { return file == "shape_seconds.csv" || file == "timings.csv"; }

bool has_results(const fs::path& folder) {
  return fs::exists(folder / manifest_name) ||
         std::ranges::any_of(result_names, [&](std::string_view name) { return fs::exists(folder / name); });
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder)) {
    throw InputError(fmt::format("cannot make the folder {} for the results: {}", folder.string(),
                                 failure ? failure.message() : "there is a file of that name"));
  }
}

std::vector<std::string> earlier_results(const fs::path& folder) {
  std::vector<std::string> files;
  try {
    if (!fs::exists(folder / manifest_name)) return {};
    for (const auto& file : read_json(folder / manifest_name).value("files", std::vector<std::string>())) {
      if (is_result(file)) files.push_back(file);
    }
  } catch (const std::exception&) {
    files.clear();  // not a manifest of ours: nothing to clear away
  }
  return files;
}

void remove_superseded(const fs::path& folder, std::span<const std::string> earlier,
                       std::span<const std::string> written) {
  std::error_code ignored;  // a file that is gone already
  for (const std::string& file : earlier) {
    if (std::ranges::find(written, file) == written.end()) fs::remove(folder / file, ignored);
  }
}

void prepare_result_folder(const fs::path& folder, const nlohmann::json& configuration, bool replace) {
  make_folder(folder);
  // Writing is tried now: it must not be found out after hours.
  const fs::path probe = folder / ".shapegauge-probe";
  write_file_atomically(probe, "");
  std::error_code ignored;
  fs::remove(probe, ignored);

  if (replace || !has_results(folder) || earlier_configuration(folder) == configuration) return;
  throw InputError(
      fmt::format("{} holds the results of another configuration; give another folder with --output, or replace them "
                  "with --replace",
                  folder.string()));
}

}  // namespace shapegauge
