#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/report.h"
#include "shapegauge/pages/report_json.h"

namespace shapegauge {

std::string report_page(const Report& report) {
  // What draws shapes weighs 0.9 MB: it is there where there are shapes to draw.
  const bool turns = !report.views.shapes.empty();
  const std::string title = html_text(report.title);
  const std::string data = script_data(report_json(report));
  const std::string style = fmt::format("{}{}{}", page_files::common_style(), turns ? page_files::view_style() : "",
                                        page_files::report_style());
  const std::string libraries =
      fmt::format("{}{}", page_files::chart_library(), turns ? page_files::shape_library() : "");
  const std::string script = fmt::format("{}{}{}", page_files::common_script(), turns ? page_files::view_script() : "",
                                         page_files::report_script());
  const std::array<std::pair<std::string_view, std::string_view>, 5> marks{{{"{{title}}", title},
                                                                            {"{{style}}", style},
                                                                            {"{{libraries}}", libraries},
                                                                            {"{{data}}", data},
                                                                            {"{{script}}", script}}};
  return filled_page(page_files::report_page(), marks);
}

}  // namespace shapegauge
