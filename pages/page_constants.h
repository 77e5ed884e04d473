// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shapegauge {

/// Returns the constants shared by the program and the pages' scripts as the module pages/common/constants.mjs: packing
/// of numbers, colour map, shading, splats. The target update_page_constants writes the file.
std::string page_constants_script();

}  // namespace shapegauge
