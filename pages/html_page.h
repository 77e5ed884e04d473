// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Building blocks of HTML pages. Pages are self-contained: styles, scripts and data are embedded.

namespace shapegauge {

/// Encodes bytes in base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

/// Rounds a value to a number of significant digits, to shorten its text.
double rounded_to_digits(double value, int digits);

/// Escapes a text for HTML content and attributes.
std::string html_text(std::string_view text);

/// Formats JSON for a script element: `<` is escaped, and so is invalid UTF-8 (escaped_json()).
std::string script_data(const nlohmann::ordered_json& json);

/// Returns an HTML page with its placeholders (marks), such as {{data}}, replaced by contents. The marks must be listed
/// in the order in which they occur on the page. Contents are not searched for marks.
std::string fill_placeholders(std::string_view page,
                              std::span<const std::pair<std::string_view, std::string_view>> marks_and_contents);

/// Contents of an HTML page that JavaScript draws.
struct ScriptedPage {
  std::string_view title;                   ///< title of the page as plain text
  std::string_view kind;                    ///< word for the kind of page in its title and heading, such as "report"
  std::string_view main;                    ///< HTML of the main part, which `script` fills
  std::vector<std::string_view> styles;     ///< CSS of this page, applied after the CSS of all pages
  std::vector<std::string_view> libraries;  ///< JavaScript libraries that `script` needs
  const nlohmann::ordered_json& data;       ///< data that `script` reads
  std::string_view script;                  ///< JavaScript that draws the page
};

/// Renders an HTML page: the common frame (pages/common/page.html), filled with the contents.
std::string scripted_page(const ScriptedPage& contents);

/// Files of pages/, its bundled scripts and the JavaScript libraries, compiled in by the build (CMakeLists.txt).
namespace page_files {

std::string_view frame();         ///< HTML frame of all pages, with placeholders such as {{data}}
std::string_view common_style();  ///< CSS of all pages, used after palette_style()

std::string_view view_page();    ///< HTML of the main part of the page of `shapegauge view`
std::string_view view_style();   ///< CSS of interactive views
std::string_view view_script();  ///< script of view_page(); needs chart_library() and shape_library()

std::string_view report_page();    ///< HTML of the main part of reports
std::string_view report_style();   ///< CSS of reports
std::string_view report_script();  ///< script of reports; needs chart_library(), and shape_library() for views

std::string_view leaderboard_page();    ///< HTML of the main part of leaderboards
std::string_view leaderboard_style();   ///< CSS of leaderboards, used after report_style()
std::string_view leaderboard_script();  ///< script of leaderboards; needs chart_library()

std::string_view search_page();    ///< HTML of the main part of search pages
std::string_view search_style();   ///< CSS of search pages
std::string_view search_script();  ///< script of search pages; needs chart_library() and shape_library()

std::string_view multi_dataset_page();    ///< HTML of the main part of multi-dataset pages
std::string_view multi_dataset_style();   ///< CSS of multi-dataset pages, used after report_style()
std::string_view multi_dataset_script();  ///< script of multi-dataset pages; needs chart_library()

std::string_view segmentation_page();    ///< HTML of the main part of segmentation pages
std::string_view segmentation_style();   ///< CSS of segmentation pages, used after view_style() and report_style()
std::string_view segmentation_script();  ///< script of segmentation pages; needs chart_library() and shape_library()

std::string_view chart_library();  ///< JavaScript library D3, with its licence
std::string_view shape_library();  ///< JavaScript library three.js, with its licence

}  // namespace page_files

}  // namespace shapegauge
