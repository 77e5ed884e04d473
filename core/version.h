// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace shapegauge {

/// Returns the version of this library, as in the project() command of the top CMakeLists.txt: "major.minor.patch".
std::string_view version();

/// Returns the git commit that this library was built from, 40 hexadecimal digits, with "-dirty" appended if tracked
/// files had changed; "unknown" if the sources are not a git checkout.
std::string_view commit();

}  // namespace shapegauge
