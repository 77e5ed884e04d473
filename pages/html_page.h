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

/// The files of pages/ and the JavaScript libraries, as the build compiles them in (page_files.cpp.in).
namespace page_files {

std::string_view common_style();   ///< of all pages
std::string_view view_style();     ///< of views
std::string_view common_script();  ///< what the scripts of all pages use
std::string_view view_script();    ///< the views, which use common_script() and both libraries
std::string_view view_page();      ///< the page of `shapegauge view`
std::string_view view_page_script();
std::string_view report_page();    ///< the page of a report, with marks such as {{data}} where the rest goes
std::string_view report_style();   ///< of reports
std::string_view report_script();  ///< of reports, with view_script() before it where the report has views
std::string_view chart_library();  ///< D3, with its licence
std::string_view shape_library();  ///< three.js, with its licence

}  // namespace page_files

}  // namespace shapegauge
