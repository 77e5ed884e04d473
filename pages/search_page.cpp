// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/search_page.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

Json packed_shape(const SearchPageShape& shape) {
  constexpr int picture_pixels = 240;
  if (!shape.view) return {{"name", shape.name}};
  Json json = shape_view_json(*shape.view);
  json["name"] = shape.name;
  json["picture"] = base64(shape_view_picture(*shape.view, picture_pixels));
  return json;
}

Json packed_answer(const SearchPageResult& answer) {
  constexpr int digits = 7;
  Json nearest = Json::array();
  for (const auto& [shape, distance] : answer.nearest) nearest.push_back({shape, rounded_to_digits(distance, digits)});
  return {{"query", answer.query}, {"failure", answer.failure}, {"nearest", std::move(nearest)}};
}

}  // namespace

std::string search_page(const SearchPage& page) {
  std::vector<Json> shapes(page.shapes.size());
  parallel_for(std::size_t{0}, shapes.size(), [&](std::size_t i) { shapes[i] = packed_shape(page.shapes[i]); });
  Json answers = Json::array();
  for (const SearchPageResult& answer : page.answers) answers.push_back(packed_answer(answer));
  return scripted_page({.title = page.title,
                        .kind = "search",
                        .main = page_files::search_page(),
                        .styles = {page_files::view_style(), page_files::search_style()},
                        .libraries = {page_files::chart_library(), page_files::shape_library()},
                        .data = {{"version", version()},
                                 {"title", page.title},
                                 {"facts", page.facts},
                                 {"shapes", std::move(shapes)},
                                 {"answers", std::move(answers)}},
                        .script = page_files::search_script()});
}

}  // namespace shapegauge
