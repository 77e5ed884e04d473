#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/palette.h"
#include "shapegauge/pages/report.h"
#include "shapegauge/pages/report_json.h"

namespace shapegauge {

std::string report_page(const Report& report) {
  // three.js has 0.6 MB: included only if there are shapes to draw.
  const bool turns = !report.views.shapes.empty();
  const std::string title = html_text(report.title);
  const std::string data = script_data(report_json(report));
  const std::string style = palette_style()
                                .append(page_files::common_style())
                                .append(turns ? page_files::view_style() : "")
                                .append(page_files::report_style());
  const std::string libraries =
      fmt::format("{}{}", page_files::chart_library(), turns ? page_files::shape_library() : "");
  const std::array<std::pair<std::string_view, std::string_view>, 5> marks{
      {{"{{title}}", title},
       {"{{style}}", style},
       {"{{libraries}}", libraries},
       {"{{data}}", data},
       {"{{script}}", page_files::report_script()}}};
  return filled_page(page_files::report_page(), marks);
}

}  // namespace shapegauge
