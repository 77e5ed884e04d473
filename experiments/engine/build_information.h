// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace shapegauge {

/// Returns the name and version of the compiler that built this library.
std::string_view compiler();

/// Returns the CMake build type, such as "Release".
std::string_view build_type();

/// Returns the versions of libraries that affect results, as a JSON object {"name": "version", ...}.
std::string_view library_versions();

}  // namespace shapegauge
