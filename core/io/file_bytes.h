#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace shapegauge {

/// The bytes of a regular file, at most `limit` of them from its beginning. Throws InputError "cannot read <path>:
/// <reason>" where the file is absent, unreadable, not a regular file, or empty.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::size_t limit = std::numeric_limits<std::size_t>::max());

/// Whether a file is on the disk itself, safe from a power cut, before it takes its name.
enum class Flush { no, yes };

/// Writes the bytes to the file at `path`, whole or not at all: into a new file beside it, which takes its place by a
/// rename once it is complete. A file that was there before stays as it was until then, and after any failure; a
/// program that is interrupted leaves no half-written file under that name. After a power cut that holds with
/// Flush::yes only.
///
/// A symbolic link is followed. What is not a regular file (/dev/stdout, a pipe) is written to directly. The folder
/// must exist. Throws InputError "cannot write <path>: <reason>" where the folder or the disk does not let it be
/// written.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes, Flush flush = Flush::no);

}  // namespace shapegauge
