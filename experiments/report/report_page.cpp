#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "shapegauge/experiments/report/report.h"
#include "shapegauge/experiments/report/report_json.h"

/// The files of experiments/report/page/, as the build compiles them in (page_files.cpp.in).
namespace shapegauge::page_files {

std::string_view page();           ///< page.html, with marks such as {{data}} where the rest goes
std::string_view style();          ///< page.css
std::string_view script();         ///< the scripts, in the order in which they run
std::string_view chart_library();  ///< D3, with its licence

}  // namespace shapegauge::page_files

namespace shapegauge {

namespace {

/// The text with every occurrence of a word replaced.
std::string replaced(std::string_view text, std::string_view word, std::string_view replacement) {
  std::string result;
  std::size_t begin = 0;
  for (std::size_t found = text.find(word); found != std::string_view::npos; found = text.find(word, begin)) {
    result.append(text, begin, found - begin).append(replacement);
    begin = found + word.size();
  }
  return result.append(text, begin);
}

/// JSON that may stand in a script element: no `<` can end it, and where text is not UTF-8, a mark stands for the
/// bytes.
std::string script_data(const nlohmann::ordered_json& json) {
  const std::string text = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return replaced(text, "<", "\\u003c");
}

std::string html_text(std::string_view text) {
  return replaced(replaced(replaced(text, "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
}

}  // namespace

std::string report_page(const Report& report) {
  const std::string title = html_text(report.title);
  const std::string data = script_data(report_json(report));
  const std::array<std::pair<std::string_view, std::string_view>, 5> parts{{{"{{title}}", title},
                                                                            {"{{style}}", page_files::style()},
                                                                            {"{{d3}}", page_files::chart_library()},
                                                                            {"{{data}}", data},
                                                                            {"{{script}}", page_files::script()}}};
  // The page is gone through once: a mark in the title or in the data is text like any other.
  std::string_view rest = page_files::page();
  std::string result;
  for (const auto& [mark, content] : parts) {
    const std::size_t found = rest.find(mark);
    result.append(rest, 0, found).append(content);
    rest.remove_prefix(found + mark.size());
  }
  return result.append(rest);
}

}  // namespace shapegauge
