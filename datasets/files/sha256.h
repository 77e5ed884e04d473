#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace shapegauge {

/// SHA-256 of the bytes, 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::string_view bytes);

/// The same of a file's contents. Throws InputError where it cannot be read or is empty.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace shapegauge
