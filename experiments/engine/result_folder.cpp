// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/result_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/configuration/json_document.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

bool is_safe(char c) {
  return (std::isalnum(static_cast<unsigned char>(c)) != 0 && (c & '\x80') == 0) || c == '-' || c == '.';
}

/// Returns true if the open file is still the one of that name.
bool is_file_of(int descriptor, const fs::path& path) {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

/// Names of result files: first those of retrieval experiments, then those of comparisons.
constexpr std::array<std::string_view, 19> result_names{
    "summary.csv",   "summary.json",      "summary.md",    "summary.tex", "intervals.csv",
    "per_class.csv", "per_query.csv",     "pr_curves.csv", report_name,   "shapes.csv",
    "distances",     "shape_seconds.csv", "distances.csv", "errors.csv",  "normals.csv",
    "timings.csv",   "histograms.csv",    "features",      "pairs.csv"};

/// Returns true if runs write files of that name, relative to the folder.
bool is_result(const fs::path& file) {
  if (file.parent_path() == "distances" || file.parent_path() == "features") return file.extension() == ".npy";
  if (std::ranges::find(result_names, file.string()) != result_names.end()) return true;
  // In an experiment on several data sets, each has its own folder.
  const std::string folder = file.empty() ? "" : file.begin()->string();
  const fs::path below = file.lexically_relative(folder);
  if (folder.empty() || folder != file_safe_name(folder) || file.is_absolute() || below == ".") return false;
  return below == manifest_name || is_result(below);
}

/// Returns the configuration in the folder's manifest; null if unknown.
nlohmann::json earlier_configuration(const fs::path& folder) {
  try {
    const nlohmann::json manifest = read_json(folder / manifest_name);
    return manifest.is_object() ? manifest.value("configuration", nlohmann::json()) : nlohmann::json();
  } catch (const InputError&) {
    return {};
  }
}

/// Returns true if the folder has a result file of any kind of run.
bool has_results(const fs::path& folder) {
  return fs::exists(folder / manifest_name) ||
         std::ranges::any_of(result_names, [&](std::string_view name) { return fs::exists(folder / name); });
}

/// Returns the results listed in an earlier run's manifest, restricted to names that runs use.
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

/// Removes earlier files that were not written again.
void remove_superseded(const fs::path& folder, std::span<const std::string> earlier,
                       std::span<const std::string> written) {
  std::error_code ignored;  // a file that is gone already
  for (const std::string& file : earlier) {
    if (std::ranges::find(written, file) == written.end()) fs::remove(folder / file, ignored);
  }
}

void move_file(const fs::path& from, const fs::path& to) {
  make_folder(to.parent_path());
  std::error_code failure;
  if (const fs::file_status earlier = fs::status(to, failure); fs::is_regular_file(earlier)) {
    fs::permissions(from, earlier.permissions(), failure);
  }
  fs::rename(from, to, failure);
  if (failure) throw InputError(fmt::format("cannot write {}: {}", to.string(), failure.message()));
}

}  // namespace

std::string file_safe_name(std::string_view name) {
  std::string safe;
  for (const char c : name) {
    if (is_safe(c)) {
      safe += c;
    } else if (!safe.ends_with('_')) {
      safe += '_';
    }
  }
  safe.resize(std::min<std::size_t>(safe.size(), 100));
  safe.erase(0, safe.find_first_not_of("_."));
  safe.erase(safe.find_last_not_of("_.") + 1);
  return safe.empty() ? "unnamed" : safe;
}

std::vector<std::string> file_safe_names(std::span<const std::string> names) {
  std::vector<std::string> safe_names;
  std::set<std::string> used;
  for (const std::string& name : names) {
    const std::string safe = file_safe_name(name);
    std::string candidate = safe;
    for (int i = 2; !used.insert(lower_case(candidate)).second; ++i) candidate = fmt::format("{}_{}", safe, i);
    safe_names.push_back(candidate);
  }
  return safe_names;
}

FolderLock::FolderLock(const fs::path& folder)
    : FolderLock(folder, [&] {
        throw InputError(fmt::format("another run is writing to {}; wait for it, or use another folder with `output`",
                                     folder.string()));
      }) {}

FolderLock::FolderLock(const fs::path& folder, const std::function<void()>& while_locked)
    : path_(folder / ".shapegauge-lock") {
  make_folder(folder);
  while (true) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw InputError(
          fmt::format("cannot write to the folder {}: {}", folder.string(), std::generic_category().message(errno)));
    }
    const int error = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    // The previous owner may have removed the file: a lock on a removed file has no effect.
    if (error != EWOULDBLOCK && (error != 0 || is_file_of(descriptor_, path_))) return;
    ::close(descriptor_);
    if (error == EWOULDBLOCK) while_locked();
  }
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

bool holds_timings(std::string_view file) {
  const std::string_view name = file.substr(file.rfind('/') + 1);
  return name == "shape_seconds.csv" || name == "timings.csv" || name == manifest_name;
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder)) {
    throw InputError(fmt::format("cannot create the folder {}: {}", folder.string(),
                                 failure ? failure.message() : "a file has that name"));
  }
}

void require_writable(const fs::path& folder) {
  make_folder(folder);
  const fs::path probe = folder / ".shapegauge-probe";
  write_file_atomically(probe, "");
  std::error_code ignored;
  fs::remove(probe, ignored);
}

void check_results_are_no_inputs(const fs::path& folder, std::span<const std::string> files,
                                 std::span<const fs::path> inputs) {
  std::vector<std::string> replaced = earlier_results(folder);
  replaced.insert(replaced.end(), files.begin(), files.end());
  std::set<fs::path> names{fs::path()};  // the folder
  for (const std::string& file : replaced) {
    for (fs::path name = file; !name.empty(); name = name.parent_path()) names.insert(name);
  }
  for (const fs::path& name : names) {
    const OutputFile output{.path = name.empty() ? folder : folder / name, .what = "the results"};
    check_output_files(inputs, {&output, 1}, true);
  }
}

void check_earlier_results(const fs::path& folder, const nlohmann::json& configuration, bool replace) {
  if (replace || !has_results(folder) || earlier_configuration(folder) == escaped_json(configuration)) return;
  throw InputError(fmt::format(
      "{} has results of another configuration; use another folder with `output`, or `replace=true`", folder.string()));
}

void prepare_result_folder(const fs::path& folder, const nlohmann::json& configuration, bool replace) {
  require_writable(folder);
  check_earlier_results(folder, configuration, replace);
}

StagedResults::StagedResults(fs::path destination)
    : destination_(std::move(destination)), folder_(destination_ / ".shapegauge-new") {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);  // of a run that was killed
  make_folder(folder_);
}

StagedResults::~StagedResults() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void StagedResults::publish(const std::vector<std::string>& files) {
  const std::vector<std::string> earlier = earlier_results(destination_);
  for (const std::string& file : files) move_file(folder_ / file, destination_ / file);
  move_file(folder_ / manifest_name, destination_ / manifest_name);
  remove_superseded(destination_, earlier, files);
}

}  // namespace shapegauge
