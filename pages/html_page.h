#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>

/// What pages of HTML are made of. They need nothing but themselves: styles, scripts and data are in them.

namespace shapegauge {

/// The bytes in base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

/// The value with so many significant digits: the fewest characters that say enough.
double rounded(double value, int digits);

/// The text as it stands in HTML, in attributes too.
std::string html_text(std::string_view text);

/// JSON that may stand in a script element: no `<` can end it, and where text is not UTF-8, a mark stands for the
/// bytes.
std::string script_data(const nlohmann::ordered_json& json);

/// The page with each mark, such as {{data}}, replaced by what goes there. Marks come in the page's order. The page is
/// gone through once: a mark in what goes there is text like any other.
std::string filled_page(std::string_view page,
                        std::span<const std::pair<std::string_view, std::string_view>> marks_and_contents);

/// The files of pages/, its bundled scripts and the JavaScript libraries, as the build compiles them in
/// (CMakeLists.txt). Pages have marks such as {{data}} where the rest goes.
namespace page_files {

std::string_view common_style();  ///< of all pages, after palette_style()

std::string_view view_page();    ///< the page of `shapegauge view`
std::string_view view_style();   ///< of interactive views
std::string_view view_script();  ///< of that page; needs both libraries

std::string_view report_page();
std::string_view report_style();
std::string_view report_script();  ///< needs the chart library, and the shape library where the report has views

std::string_view leaderboard_page();
std::string_view leaderboard_style();   ///< after report_style()
std::string_view leaderboard_script();  ///< needs the chart library

std::string_view search_page();
std::string_view search_style();
std::string_view search_script();  ///< needs both libraries

std::string_view collection_page();
std::string_view collection_style();   ///< after report_style()
std::string_view collection_script();  ///< needs the chart library

std::string_view segmentation_page();
std::string_view segmentation_style();

std::string_view chart_library();  ///< D3, with its licence
std::string_view shape_library();  ///< three.js, with its licence

}  // namespace page_files

}  // namespace shapegauge
