// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

namespace shapegauge {

/// Returns the contents of a regular file, or its first `limit` bytes if the file is longer. Throws InputError "cannot
/// read <path>: <reason>" if the file is absent, unreadable, not a regular file, or empty.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::size_t limit = std::numeric_limits<std::size_t>::max());

/// Contents of a file, mapped or read into memory by map_file(), and the owner of this memory.
struct MappedBytes {
  std::shared_ptr<const void> memory;  ///< owner of the memory: destroying its last copy unmaps the file
  std::string_view bytes;              ///< contents of the file; valid while `memory` or a copy of it exists
};

/// Maps a file into memory, read-only, which avoids copying a large file. Replacing the file leaves the mapped bytes
/// unchanged, overwriting it in place changes them, and truncating it crashes a program that reads them. Reads the file
/// into memory if the file system cannot map it. Throws InputError as read_file_bytes() does.
MappedBytes map_file(const std::filesystem::path& path);

/// Whether a file is flushed to disk before it is renamed to its final path, which protects it from power failures.
enum class Flush { no, yes };

/// File that is written in pieces under a temporary name and renamed to its path when complete, as by
/// write_file_atomically(). The destructor deletes the temporary file if publish() was not called, for example after an
/// exception.
class AtomicFile {
 public:
  /// Opens a temporary file next to `path`, or `path` itself if it is a device or pipe. Throws InputError on failure.
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Appends bytes to the file. Throws InputError if they cannot be written.
  void write(std::string_view bytes);

  /// Closes the temporary file and renames it to the constructor's path. Call once. Throws InputError on failure.
  void publish(Flush flush = Flush::no);

 private:
  std::filesystem::path path_;        ///< path of the complete file
  std::filesystem::path target_;      ///< `path_` with symbolic links resolved
  std::filesystem::path unfinished_;  ///< path of the temporary file; empty when writing directly to `path_`
  int descriptor_ = -1;               ///< file descriptor of the open file; -1 if closed
};

/// Declares whether the file that this process writes to `path` next must be new. If so, and if another process creates
/// `path` first, AtomicFile::publish() fails instead of replacing the file.
void expect_new_file(const std::filesystem::path& path, bool is_new);

/// Writes a file atomically: to a new file next to `path`, renamed when complete. An existing file stays unchanged
/// until the rename and after any failure, and an interrupted program leaves no partial file at `path`. After a power
/// failure this holds only with Flush::yes. The new file has the permissions of the existing one.
///
/// Follows symbolic links. Writes directly to anything that is not a regular file (/dev/stdout, a pipe). The folder
/// must exist. Throws InputError "cannot write <path>: <reason>" if the file cannot be written.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes, Flush flush = Flush::no);

}  // namespace shapegauge
