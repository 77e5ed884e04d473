// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/report.h"
#include "shapegauge/pages/report_json.h"

namespace shapegauge {

std::string report_page(const Report& report) {
  // three.js has 0.6 MB: included only if there are shapes to draw.
  const bool turns = !report.views.shapes.empty();
  return scripted_page({.title = report.title,
                        .kind = "report",
                        .main = page_files::report_page(),
                        .styles = {turns ? page_files::view_style() : "", page_files::report_style()},
                        .libraries = {page_files::chart_library(), turns ? page_files::shape_library() : ""},
                        .data = report_json(report),
                        .script = page_files::report_script()});
}

}  // namespace shapegauge
