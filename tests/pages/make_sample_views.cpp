// SPDX-License-Identifier: GPL-3.0-or-later
// make_sample_views FOLDER: writes the sample pages for a browser to open, and for tests of scripts its shapes with the
// corners of the splats.
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/render/splats.h"
#include "tests/pages/sample_segmentation.h"
#include "tests/pages/sample_views.h"

// NOLINTNEXTLINE(bugprone-exception-escape): ends the program, and the test that runs it fails
int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::cerr << "usage: make_sample_views FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  shapegauge::write_file_atomically(folder / "two.html", shapegauge::view_page(shapegauge::test_view::page()));
  shapegauge::write_file_atomically(folder / "search.html",
                                    shapegauge::search_page(shapegauge::test_view::sample_search()));
  shapegauge::write_file_atomically(folder / "segmentation.html",
                                    shapegauge::segmentation_page(shapegauge::test_segmentation::sample_page()));
  const shapegauge::ShapeView cloud = shapegauge::test_view::cloud();
  nlohmann::ordered_json corners = nlohmann::ordered_json::array();
  const shapegauge::Shape hexagons = shapegauge::splats(cloud.shape);
  for (const auto& corner : hexagons.vertices.rowwise()) {
    corners.push_back({corner[0], corner[1], corner[2]});
  }
  const nlohmann::ordered_json json{{"balls", shape_view_json(shapegauge::test_view::balls())},
                                    {"cloud", shape_view_json(cloud)},
                                    {"splats", std::move(corners)}};
  shapegauge::write_file_atomically(folder / "view.json", json.dump());
  return 0;
}
