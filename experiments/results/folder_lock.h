#pragma once

#include <filesystem>

namespace shapegauge {

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

}  // namespace shapegauge
