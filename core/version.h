#pragma once

#include <string_view>

namespace shapegauge {

/// The version of this library, as in the project() command of the top CMakeLists.txt: "major.minor.patch".
std::string_view version();

/// The git commit this library was built from, 40 hexadecimal digits, with "-dirty" appended when files under version
/// control had been changed; "unknown" where the sources are not a git checkout.
std::string_view commit();

}  // namespace shapegauge
