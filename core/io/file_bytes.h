#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace shapegauge {

/// Reads at most `limit` leading bytes of a regular file. Throws InputError "cannot read <path>: <reason>" if the file
/// is absent, unreadable, not a regular file, or empty.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::size_t limit = std::numeric_limits<std::size_t>::max());

/// Flushing of a file to disk before it is renamed, which protects it from power failures.
enum class Flush { no, yes };

/// Writes a file atomically: to a new file beside `path`, renamed when complete. An existing file stays unchanged until
/// then and after any failure, and an interrupted program leaves no partial file under that name. After a power failure
/// this holds only with Flush::yes.
///
/// Follows symbolic links. Writes directly to anything that is not a regular file (/dev/stdout, a pipe). The folder
/// must exist. Throws InputError "cannot write <path>: <reason>" if the file cannot be written.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes, Flush flush = Flush::no);

}  // namespace shapegauge
