#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The name with everything but letters, digits, `.`, `-` and `_` of ASCII replaced by one `_` each run, none at the
/// ends, at most 100 characters; never empty, hidden, `.` or `..`. For "Our SDF (d = 1%)": "Our_SDF_d_1".
std::string file_safe_name(std::string_view name);

/// A file-safe name for each name, no two alike even where upper and lower case are one: later ones get _2, _3, ...
std::vector<std::string> file_safe_names(std::span<const std::string> names);

/// While it lives, the folder is this run's own: no other run can have its lock. It is a lock of the operating system
/// (flock) on a file in the folder, so that a run that is killed leaves none behind. Where the file system knows no
/// locks, nothing is locked.
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

/// The name of the file in the folder that is written last and lists the others.
inline constexpr std::string_view manifest_name = "manifest.json";

/// The name of the page that shows the results.
inline constexpr std::string_view report_name = "report.html";

/// Whether the result file of that name holds seconds, which differ from run to run.
bool holds_timings(std::string_view file);

/// Whether a file that a run of any kind writes is in the folder.
bool has_results(const std::filesystem::path& folder);

/// Makes the folder, where absent. Throws InputError where that is not possible.
void make_folder(const std::filesystem::path& folder);

/// The results that the manifest of an earlier run in the folder lists: names that runs give to files and no others.
std::vector<std::string> earlier_results(const std::filesystem::path& folder);

/// Removes those of the earlier files that have not been written anew.
void remove_superseded(const std::filesystem::path& folder, std::span<const std::string> earlier,
                       std::span<const std::string> written);

/// Makes the folder for a run's results ready, before the run. A folder that is new, has no results in it, or has those
/// of the very same configuration may be used: repeating a run replaces its files. Throws InputError where the folder
/// holds the results of something else, unless `replace` is set, or cannot be made or written to.
void prepare_result_folder(const std::filesystem::path& folder, const nlohmann::json& configuration, bool replace);

/// New results on their way into a folder that may hold earlier ones. They are written into a folder of their own
/// inside it first; only when all are there do they take the place of the earlier ones. A disk that fills up on the way
/// thus leaves the earlier results as they were.
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
