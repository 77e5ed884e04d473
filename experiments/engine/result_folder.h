// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Makes a safe file name: replaces every run of characters other than ASCII letters, digits, ".", "-" and "_" by one
/// "_", with none at the ends. 1 to 100 characters, never hidden, "." or "..". "Our SDF (d = 1%)" becomes
/// "Our_SDF_d_1".
std::string file_safe_name(std::string_view name);

/// Makes safe file names that are distinct even ignoring case: repeated ones get _2, _3, ....
std::vector<std::string> file_safe_names(std::span<const std::string> names);

/// Lock on a result folder for the lifetime of the object. Uses a lock of the operating system (flock) on a file in the
/// folder, which a killed run leaves unlocked. Has no effect on file systems without locks.
class FolderLock {
 public:
  /// Creates the folder if missing and locks it. Throws InputError if it cannot be created or written to, or if another
  /// run has locked it.
  explicit FolderLock(const std::filesystem::path& folder);
  /// Creates the folder if missing and locks it. While another run has locked it, calls `while_locked` repeatedly.
  /// Throws InputError if the folder cannot be created or written to.
  FolderLock(const std::filesystem::path& folder, const std::function<void()>& while_locked);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();  ///< unlocks the folder

 private:
  std::filesystem::path path_;  ///< locked file in the folder
  int descriptor_ = -1;         ///< file descriptor of the locked file
};

/// Name of the manifest of a run, the result file that is written last and lists the others.
inline constexpr std::string_view manifest_name = "manifest.json";

/// Name of the HTML report among the result files.
inline constexpr std::string_view report_name = "report.html";

/// Returns true if a result file of that name has run times, which vary between runs.
bool holds_timings(std::string_view file);

/// Creates a folder if missing. Throws InputError if that fails.
void make_folder(const std::filesystem::path& folder);

/// Creates a folder if missing and checks that files can be written to it, for use before a long run. Throws InputError
/// if that fails.
void require_writable(const std::filesystem::path& folder);

/// Throws InputError if the results of a run would overwrite one of the input files or folders. Results are `folder`,
/// the result files `files` (names relative to `folder`), the files that the manifest of an earlier run lists there,
/// and the subfolders of these files.
void check_results_are_no_inputs(const std::filesystem::path& folder, std::span<const std::string> files,
                                 std::span<const std::filesystem::path> inputs);

/// Throws InputError if the folder has results of another configuration, unless `replace` is set.
void check_earlier_results(const std::filesystem::path& folder, const nlohmann::json& configuration, bool replace);

/// Prepares the result folder before a run. The folder may be new, have no results, or have those of the same
/// configuration, which a repeated run replaces. Throws InputError if it has other results, unless `replace` is set, or
/// cannot be created or written to.
void prepare_result_folder(const std::filesystem::path& folder, const nlohmann::json& configuration, bool replace);

/// Staging of new results in a folder that may have earlier ones. Files are written to a subfolder and replace the
/// earlier ones only when all are complete. A disk that becomes full therefore leaves earlier results intact.
class StagedResults {
 public:
  /// Creates the folder and an empty staging folder inside it. Throws InputError if that fails. The caller must have
  /// locked the folder (FolderLock).
  explicit StagedResults(std::filesystem::path destination);
  StagedResults(const StagedResults&) = delete;
  StagedResults& operator=(const StagedResults&) = delete;
  StagedResults(StagedResults&&) = delete;
  StagedResults& operator=(StagedResults&&) = delete;
  /// Removes files that were not published.
  ~StagedResults();

  /// Returns the staging folder.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Moves the files, by name in folder(), to the result folder, and finally the manifest, which must also be in
  /// folder(). Then removes files of an earlier run that this run did not write. Throws InputError if a file cannot be
  /// moved.
  void publish(const std::vector<std::string>& files);

 private:
  std::filesystem::path destination_;  ///< result folder
  std::filesystem::path folder_;       ///< staging folder in the result folder
};

}  // namespace shapegauge
