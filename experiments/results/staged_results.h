#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace shapegauge {

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
