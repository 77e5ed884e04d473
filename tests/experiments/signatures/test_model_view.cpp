// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/signatures/model_view.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using nlohmann::ordered_json;

ordered_json view_of(const Shape& shape, const Eigen::VectorXd& values, const Samples& samples, Eigen::Index faces) {
  const std::vector<SampledField> fields{{.samples = samples, .values = values}};
  return ordered_json::parse(model_view(shape, fields, {.faces = faces}));
}

TEST(ModelView, HasAtMostTheRequestedFacesAndTheRangeOfTheField) {
  const Shape sphere = test::sphere(1, 4);  // 5120 faces
  for (const SampleSite site : {SampleSite::faces, SampleSite::vertices, SampleSite::surface}) {
    const Samples samples = site == SampleSite::surface ? sample_surface(sphere, 2000) : sample_shape(sphere, site);
    const Eigen::VectorXd heights = samples.points.col(2);
    const ordered_json view = view_of(sphere, heights, samples, 600);
    EXPECT_LE(view["triangles"]["count"], 600);
    EXPECT_GE(view["triangles"]["count"], 300);
    EXPECT_EQ(view["site"], "vertices");
    const ordered_json field = view["fields"][0];
    // Means around vertices have a slightly smaller range than the field. Heights are uniform on a sphere.
    EXPECT_NEAR(field["low"].get<double>(), -1, 0.06);
    EXPECT_NEAR(field["high"].get<double>(), 1, 0.06);
    EXPECT_NEAR(field["from"].get<double>(), -0.96, 0.02);
    EXPECT_NEAR(field["to"].get<double>(), 0.96, 0.02);
  }
}

TEST(ModelView, KeepsSmallMeshesUnchanged) {
  const Shape box = test::box({1, 2, 3}, 2);
  const Samples samples = sample_shape(box, SampleSite::vertices);
  const ordered_json view = view_of(box, samples.points.col(0), samples, 200);
  EXPECT_EQ(view["triangles"]["count"], box.triangles.rows());
  EXPECT_EQ(view["fields"][0]["low"], samples.points.col(0).minCoeff());
  EXPECT_EQ(view["fields"][0]["high"], samples.points.col(0).maxCoeff());
}

TEST(ModelView, HasFewerFacesIfAReportShowsMoreModels) {
  EXPECT_EQ(faces_of_views(1), faces_of_views(60));
  EXPECT_EQ(faces_of_views(600), 400);
  EXPECT_GT(faces_of_views(100), faces_of_views(300));
  EXPECT_GE(faces_of_views(max_models_with_views), 150);
}

}  // namespace

}  // namespace shapegauge
