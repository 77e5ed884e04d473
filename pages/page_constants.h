// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shapegauge {

/// Returns the text of the JavaScript module pages/common/constants.mjs: constants that the program and the pages'
/// scripts share for packing of numbers, colour map, shading and splats. The build target update_page_constants writes
/// the file.
std::string page_constants_script();

}  // namespace shapegauge
