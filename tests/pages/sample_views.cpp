// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pages/sample_views.h"

#include <limits>

#include "tests/support/test_shapes.h"

namespace shapegauge::test_view {

ShapeView balls() {
  const Shape large = test::sphere(1, 3);
  const Eigen::Index faces = large.triangles.rows();
  ShapeView view{.name = "</script><b>balls</b> & \"quotes\"",
                 .shape = test::joined(
                     {large, test::transformed(test::sphere(0.25, 3), 1, Eigen::Matrix3d::Identity(), {2, 0, 0})})};
  const Samples samples = sample_shape(view.shape, SampleSite::faces);
  Eigen::VectorXd thickness = Eigen::VectorXd::Constant(2 * faces, 2);
  thickness.tail(faces).setConstant(0.5);
  Eigen::VectorXd rare = Eigen::VectorXd::Constant(2 * faces, std::numeric_limits<double>::quiet_NaN());
  rare.head(2).setOnes();  // 0.15 % of the area
  view.fields = {{.name = "thickness", .values = thickness, .colours = {.low = 0.5, .high = 2}, .measured_by = "ball"},
                 {.name = "height", .values = samples.points.col(2), .colours = {.low = -1, .high = 1}},
                 {.name = "rare", .values = rare, .colours = {.low = 0, .high = 2}}};
  std::vector<std::int32_t> labels(static_cast<std::size_t>(2 * faces), 0);
  std::fill(labels.begin() + faces, labels.end(), 1);
  view.parts = {{.name = "Parts", .labels = labels, .colours = {Colour{200, 40, 40}, Colour{40, 40, 200}}}};
  view.normals = samples.normals;
  view.regions = {{.text = "small <ball>", .position = {2.25, 0, 0}, .towards_viewer = {1, 0, 0}, .size = 0.5}};
  return view;
}

ShapeView cloud() {
  ShapeView view{
      .name = "cloud", .shape = test::random_points(test::sphere(0.5, 4), 800, 1), .site = SampleSite::vertices};
  view.fields = {{.name = "thickness", .values = Eigen::VectorXd::Constant(800, 1), .colours = {.low = 1, .high = 1}}};
  return view;
}

ViewPage page() { return {.title = "Balls & <clouds>", .shapes = {balls(), cloud()}, .missing = {"broken<i>.off"}}; }

SearchPage sample_search() {
  return {.title = "<b>title</b> {{script}}",
          .facts = {"2 queries", "3 shapes in the collection"},
          .shapes = {{.name = "query </script>.off", .view = balls()},
                     {.name = "near.off", .view = cloud()},
                     {.name = "far.off", .view = balls()},
                     {.name = "lost.off", .view = {}},
                     {.name = "broken.off", .view = {}}},
          .answers = {{.query = 0, .nearest = {{1, 0.25}, {2, 0.5}, {3, 0.75}}},
                      {.query = 4, .nearest = {}, .failure = "line 3: <nothing>"}}};
}

}  // namespace shapegauge::test_view
