#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "shapegauge/experiments/report/report.h"
#include "shapegauge/experiments/report/report_json.h"
#include "shapegauge/experiments/view/html_page.h"

/// The files of experiments/report/page/, as the build compiles them in (page_files.cpp.in).
namespace shapegauge::page_files {

std::string_view page();    ///< page.html, with marks such as {{data}} where the rest goes
std::string_view style();   ///< page.css
std::string_view script();  ///< the scripts, in the order in which they run

}  // namespace shapegauge::page_files

namespace shapegauge {

std::string report_page(const Report& report) {
  // What draws shapes weighs 0.9 MB: it is there where there are shapes to draw.
  const bool turns = !report.views.shapes.empty();
  const std::string title = html_text(report.title);
  const std::string data = script_data(report_json(report));
  const std::string style =
      fmt::format("{}{}{}", page_files::common_style(), turns ? page_files::view_style() : "", page_files::style());
  const std::string libraries =
      fmt::format("{}{}", page_files::chart_library(), turns ? page_files::shape_library() : "");
  const std::string script =
      fmt::format("{}{}{}", page_files::common_script(), turns ? page_files::view_script() : "", page_files::script());
  const std::array<std::pair<std::string_view, std::string_view>, 5> marks{{{"{{title}}", title},
                                                                            {"{{style}}", style},
                                                                            {"{{libraries}}", libraries},
                                                                            {"{{data}}", data},
                                                                            {"{{script}}", script}}};
  return filled_page(page_files::page(), marks);
}

}  // namespace shapegauge
