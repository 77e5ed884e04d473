// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/segmentation_page.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/score_json.h"

namespace shapegauge {

namespace {

using SegmentationJson = nlohmann::ordered_json;

SegmentationJson errors_json(const SegmentationPageErrors& errors) {
  SegmentationJson tables = SegmentationJson::array();
  for (const TextTable& table : errors.tables) tables.push_back(table_json(table));
  return {{"weights", errors.triangle_weights},
          {"tables", std::move(tables)},
          {"methods", errors.methods},
          {"by_class", errors.by_class}};  // null: undefined
}

SegmentationJson figure_json(const SegmentationFigure& figure) {
  SegmentationJson pictures = SegmentationJson::array();
  for (const SegmentationPicture& picture : figure.pictures) {
    pictures.push_back({{"png", base64(picture.png)}, {"caption", picture.caption}});
  }
  SegmentationJson view = figure.view.empty() ? SegmentationJson() : SegmentationJson::parse(figure.view);
  return {{"title", figure.title}, {"pictures", std::move(pictures)}, {"view", std::move(view)}};
}

}  // namespace

std::string segmentation_page(const SegmentationPage& page) {
  SegmentationJson shown = SegmentationJson::array();
  for (const SegmentationFigure& figure : page.shown) shown.push_back(figure_json(figure));
  return scripted_page(
      {.title = page.title,
       .kind = "segmentation report",
       .main = page_files::segmentation_page(),
       .styles = {page_files::view_style(), page_files::report_style(), page_files::segmentation_style()},
       .libraries = {page_files::chart_library(), page_files::shape_library()},
       .data = {{"version", version()},
                {"title", page.title},
                {"description", page.description},
                {"classes", page.classes},
                {"labels", page.labels},
                {"errors", page.errors ? errors_json(*page.errors) : SegmentationJson()},
                {"perturbation_effects", table_json(page.perturbation_effects)},
                {"consistency", table_json(page.consistency)},
                {"failures", page.failures},
                {"shown", std::move(shown)},
                {"typical", page.typical}},
       .script = page_files::segmentation_script()});
}

}  // namespace shapegauge
