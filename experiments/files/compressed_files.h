#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace shapegauge {

/// The extension that tells a file's format, in lower case: that of the name, without `.gz`.
std::string format_extension(const std::filesystem::path& path);

/// The bytes of a file; where its name ends in `.gz`, what is compressed in it. Throws InputError as read_file_bytes,
/// and where it is no gzip file or a damaged one.
std::string read_plain_bytes(const std::filesystem::path& path);

/// The `.npy` file of the only array of a NumPy `.npz` archive, given its bytes. Throws InputError where it is no such
/// archive, is damaged, or has another number of arrays than one, which are then named.
std::string array_in_npz(std::string_view bytes, const std::string& source);

}  // namespace shapegauge
