#pragma once

#include <string_view>

/// The files that the report's page is made of (experiments/report/page/), as the program carries them.
namespace shapegauge::page_files {

std::string_view page();           ///< page.html, with marks such as {{data}} where the rest goes
std::string_view style();          ///< page.css
std::string_view script();         ///< the scripts, in the order in which they run
std::string_view chart_library();  ///< D3, with its licence

}  // namespace shapegauge::page_files
