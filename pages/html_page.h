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

/// Formats JSON for a script element: `<` is escaped, and invalid UTF-8 is replaced by a mark.
std::string script_data(const nlohmann::ordered_json& json);

/// Replaces each mark of a page, such as {{data}}, by its content. Marks are in the page's order. Contents are not
/// searched for marks.
std::string filled_page(std::string_view page,
                        std::span<const std::pair<std::string_view, std::string_view>> marks_and_contents);

/// Contents of a page that scripts draw.
struct ScriptedPage {
  std::string_view title;                   ///< plain text
  std::string_view kind;                    ///< what the page is, such as "report"
  std::string_view main;                    ///< HTML of the main part, which scripts fill
  std::vector<std::string_view> styles;     ///< after those of all pages
  std::vector<std::string_view> libraries;  ///< scripts that `script` needs
  const nlohmann::ordered_json& data;
  std::string_view script;
};

/// Renders the frame of all pages (pages/common/page.html) with the contents.
std::string scripted_page(const ScriptedPage& contents);

/// Files of pages/, its bundled scripts and the JavaScript libraries, compiled in by the build (CMakeLists.txt).
namespace page_files {

std::string_view frame();         ///< of all pages, with marks such as {{data}} for their contents
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

std::string_view multi_dataset_page();
std::string_view multi_dataset_style();   ///< after report_style()
std::string_view multi_dataset_script();  ///< needs the chart library

std::string_view segmentation_page();
std::string_view segmentation_style();   ///< after view_style() and report_style()
std::string_view segmentation_script();  ///< needs both libraries

std::string_view chart_library();  ///< D3, with its licence
std::string_view shape_library();  ///< three.js, with its licence

}  // namespace page_files

}  // namespace shapegauge
