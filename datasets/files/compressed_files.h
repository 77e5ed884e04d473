#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace shapegauge {

/// The extension that tells a file's format, in lower case: that of the name, without `.gz`.
std::string format_extension(const std::filesystem::path& path);

/// Largest number of bytes that a file of `packed` bytes may unpack to: 256 MiB, or 50 times `packed` where that is
/// more, but at most 16 GiB. Tables of numbers shrink to a half or a tenth of their size.
std::size_t most_unpacked_bytes(std::size_t packed);

/// Throws InputError for a file that unpacks to more than most_unpacked_bytes().
[[noreturn]] void fail_unpacking(const std::string& source, std::size_t packed);

/// The bytes of a file; where its name ends in `.gz`, what is compressed in it. Throws InputError as read_file_bytes,
/// where it is no gzip file or a damaged one, and where it unpacks to more than most_unpacked_bytes().
std::string read_plain_bytes(const std::filesystem::path& path);

/// The `.npy` file of the only array of a NumPy `.npz` archive, given its bytes. Throws InputError where it is no such
/// archive, is damaged, unpacks to more than most_unpacked_bytes(), or has another number of arrays than one, which are
/// then named.
std::string array_in_npz(std::string_view bytes, const std::string& source);

}  // namespace shapegauge
