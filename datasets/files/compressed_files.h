// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace shapegauge {

/// Returns the extension that determines a file's format, in lower case, with the dot: ".npy" for a.NPY.gz.
std::string format_extension(const std::filesystem::path& path);

/// Returns the maximum size to which a file of `packed` bytes may unpack: 256 MiB or 50 times `packed`, whichever is
/// larger, but at most 16 GiB. Tables of numbers typically shrink to between a half and a tenth of their size.
std::size_t max_unpacked_bytes(std::size_t packed);

/// Throws InputError for the file `source` of `packed` bytes, which unpacks to more than max_unpacked_bytes().
[[noreturn]] void fail_unpacking(const std::string& source, std::size_t packed);

/// Reads a file, decompressed if its name ends in `.gz`. Throws InputError as read_file_bytes() does, for an invalid or
/// damaged gzip file (checksum, size, bytes after its end), and for one that unpacks to more than
/// max_unpacked_bytes().
std::string read_plain_bytes(const std::filesystem::path& path);

/// Reads a text file as read_plain_bytes() does, converted to UTF-8 if it is UTF-16.
std::string read_plain_text(const std::filesystem::path& path);

/// Extracts the `.npy` file of the array named `variable` from the bytes of a NumPy `.npz` archive. If `variable` is
/// empty, the archive must have one array. Throws InputError, with `source`, for an invalid or damaged archive, one
/// that unpacks to more than max_unpacked_bytes(), and one without this array; the message lists the arrays.
std::string extract_npz_array(std::string_view bytes, const std::string& source, const std::string& variable = "");

}  // namespace shapegauge
