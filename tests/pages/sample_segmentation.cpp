// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pages/sample_segmentation.h"

#include <nlohmann/json.hpp>

#include "tests/pages/sample_views.h"

namespace shapegauge::test_segmentation {

namespace {

const std::string& view_of_balls() {
  static const std::string view = [] {
    ShapeView shape = test_view::balls();
    shape.fields.clear();
    shape.parts.push_back(shape.parts.front());
    shape.parts.front().name = "reference";
    shape.parts.back().name = "<i>best</i>";
    return shape_view_json(shape).dump();
  }();
  return view;
}

const std::string& picture_of_balls() {
  static const std::string picture = shape_view_picture(test_view::balls(), 64);
  return picture;
}

}  // namespace

SegmentationPage sample_page() {
  SegmentationPage page;
  page.title = "<b>title</b> {{data}}";
  page.description = "a \"description\" & more";
  page.classes = {"</script>", "cups"};
  page.labels = {0, 1};
  page.consistency = {.header = {"method", "parts"}, .rows = {{"<i>best</i>", "3"}, {"paper", "12"}}};
  page.errors = SegmentationPageErrors{
      .triangle_weights = "by area",
      .tables = {{.header = {"method", "Rand"}, .rows = {{"<i>best</i>", "0.300"}, {"paper", "0.100"}}}},
      .methods = {"<i>best</i>", "paper"},
      .by_class = {{0.2, 0.1}, {0.4, std::nan("")}}};
  page.failures = {{"lost.off", "line 3: <nothing>"}};
  const std::vector<SegmentationPicture> pictures = {{picture_of_balls(), "reference"},
                                                     {picture_of_balls(), "<i>best</i>: 0.400"}};
  page.shown = {{.title = "2 (cups)", .pictures = pictures, .view = view_of_balls()},
                {.title = "1 (</script>)", .pictures = pictures}};
  page.typical = {1};
  return page;
}

}  // namespace shapegauge::test_segmentation
