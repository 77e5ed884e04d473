#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace shapegauge {

/// What is wrong with a file, in the same words for every format: the part of the message behind file and line.
/// @{
std::string message_truncated(std::int64_t got, std::int64_t expected, std::string_view what);
std::string message_no_such_vertex(std::int64_t face, std::int64_t vertex, std::int64_t vertices);
std::string message_not_finite(std::int64_t vertex, std::string_view what = "coordinate");
std::string message_no_triangles(std::int64_t faces);
/// @}

}  // namespace shapegauge
