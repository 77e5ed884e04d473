#pragma once

#include <string_view>

namespace shapegauge {

/// The compiler that built this library, name and version.
std::string_view compiler();

/// The CMake build type, such as "Release".
std::string_view build_type();

/// Versions of the libraries that results depend on, as a JSON object {"name": "version", ...}.
std::string_view library_versions();

}  // namespace shapegauge
