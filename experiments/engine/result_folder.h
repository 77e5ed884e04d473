#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The name with every run of characters other than ASCII letters, digits, `.`, `-` and `_` replaced by one `_`, none
/// at the ends; 1 to 100 characters, never hidden, `.` or `..`. For "Our SDF (d = 1%)": "Our_SDF_d_1".
std::string file_safe_name(std::string_view name);

/// A file-safe name for each name, all different even where case does not count: later ones get _2, _3, ...
std::vector<std::string> file_safe_names(std::span<const std::string> names);

/// A lock on a result folder, held for the object's lifetime. It is a lock of the operating system (flock) on a file in
/// the folder: a run that is killed leaves none behind. On a file system without locks nothing is locked.
class FolderLock {
 public:
  /// Makes the folder where it is absent. Throws InputError where it cannot be made or written to, and where another
  /// run has it.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// The file that is written last and lists the others.
inline constexpr std::string_view manifest_name = "manifest.json";

/// The page that shows the results.
inline constexpr std::string_view report_name = "report.html";

/// Whether the result file of that name holds seconds, which differ from run to run.
bool holds_timings(std::string_view file);

/// Makes the folder, where absent. Throws InputError where that is not possible.
void make_folder(const std::filesystem::path& folder);

/// Prepares the result folder before a run. A folder is usable that is new, holds no results, or holds those of the
/// same configuration: repeating a run replaces its files. Throws InputError where the folder holds the results of
/// something else, unless `replace` is set, or cannot be made or written to.
void prepare_result_folder(const std::filesystem::path& folder, const nlohmann::json& configuration, bool replace);

/// New results for a folder that may hold earlier ones. They are written to a folder of their own inside it and replace
/// the earlier ones only when all are complete: a disk that fills up on the way leaves the earlier results as they
/// were.
class StagedResults {
 public:
  /// Makes the folder and, empty, the one inside it. Throws InputError where that is not possible. Nobody else may do
  /// the same at the same time (FolderLock).
  explicit StagedResults(std::filesystem::path destination);
  StagedResults(const StagedResults&) = delete;
  StagedResults& operator=(const StagedResults&) = delete;
  StagedResults(StagedResults&&) = delete;
  StagedResults& operator=(StagedResults&&) = delete;
  /// Removes what was not published.
  ~StagedResults();

  /// Where to write the results.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Moves the files, by name in folder(), to their places, the manifest, which is there besides, at last; then removes
  /// what an earlier run wrote and this one has not. Throws InputError where a file cannot be moved.
  void publish(const std::vector<std::string>& files);

 private:
  std::filesystem::path destination_;
  std::filesystem::path folder_;
};

}  // namespace shapegauge
