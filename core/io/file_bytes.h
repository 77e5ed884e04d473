// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

namespace shapegauge {

/// Reads at most `limit` leading bytes of a regular file. Throws InputError "cannot read <path>: <reason>" if the file
/// is absent, unreadable, not a regular file, or empty.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::size_t limit = std::numeric_limits<std::size_t>::max());

/// Bytes of a file and the memory that they are in.
struct MappedBytes {
  std::shared_ptr<const void> memory;  ///< unmaps the file when nobody has it any more
  std::string_view bytes;
};

/// Maps a file into memory, read-only: a large file is then not copied. Replacing the file leaves the bytes as they
/// are, overwriting it in place changes them, and truncating it crashes a program that reads them. Reads the file where
/// the file system cannot map it. Throws InputError as read_file_bytes() does.
MappedBytes map_file(const std::filesystem::path& path);

/// Flushing of a file to disk before it is renamed, which protects it from power failures.
enum class Flush { no, yes };

/// File that is written in pieces and renamed to its path when complete (write_file_atomically()). Deleted without
/// publish(), for example after an exception.
class AtomicFile {
 public:
  /// Opens the file for writing. Throws InputError.
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Appends the bytes. Throws InputError.
  void write(std::string_view bytes);

  /// Closes the file and renames it to its path. Call once. Throws InputError.
  void publish(Flush flush = Flush::no);

 private:
  std::filesystem::path path_;
  std::filesystem::path target_;      ///< `path_` without links
  std::filesystem::path unfinished_;  ///< empty when writing directly to `path_`
  int descriptor_ = -1;
};

/// Declares whether the next file of this name, written by this process, must be new. If another process creates it
/// first, AtomicFile::publish() then fails instead of replacing it.
void expect_new_file(const std::filesystem::path& path, bool is_new);

/// Writes a file atomically: to a new file next to `path`, renamed when complete. An existing file stays unchanged
/// until then and after any failure, and an interrupted program leaves no partial file under that name. After a power
/// failure this holds only with Flush::yes. The new file has the permissions of the existing one.
///
/// Follows symbolic links. Writes directly to anything that is not a regular file (/dev/stdout, a pipe). The folder
/// must exist. Throws InputError "cannot write <path>: <reason>" if the file cannot be written.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes, Flush flush = Flush::no);

}  // namespace shapegauge
