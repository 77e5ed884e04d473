#pragma once

#include <string>

namespace shapegauge {

/// What the scripts of the pages have in common with the program, as the module pages/common/constants.mjs: packing of
/// numbers, the colour map, shading, splats. The target update_page_constants writes the file.
std::string page_constants_script();

}  // namespace shapegauge
