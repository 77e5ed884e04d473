// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>
#include <tbb/global_control.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/render/camera.h"
#include "shapegauge/core/render/splats.h"
#include "shapegauge/pages/html_page.h"
#include "tests/pages/sample_views.h"
#include "tests/support/decoded_png.h"
#include "tests/support/page_text.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;

/// The bytes of a text in base64, by its definition.
Bytes bytes_of(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Bytes bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count & 255));
  }
  return bytes;
}

std::vector<int> shorts_of(const Json& text) {
  const Bytes bytes = bytes_of(text);
  std::vector<int> numbers;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) numbers.push_back(bytes[i] + 256 * bytes[i + 1]);
  return numbers;
}

std::vector<int> corners_of(const Json& triangles) {
  std::vector<int> corners;
  int unused = 0;
  int back = 0;
  int shift = 0;
  for (const std::uint8_t byte : bytes_of(triangles["corners"])) {
    back |= (byte & 127) << shift;
    shift += 7;
    if (byte > 127) continue;
    corners.push_back(unused - back);
    if (back == 0) ++unused;
    back = shift = 0;
  }
  return corners;
}

/// Where the corners of the packed mesh's triangles are, up to a common shift.
Points corner_points(const Json& json) {
  const std::vector<int> levels = shorts_of(json["vertices"]["values"]);
  const double step = json["vertices"]["step"];
  const std::vector<int> corners = corners_of(json["triangles"]);
  Points points(std::ssize(corners), 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      points(static_cast<Eigen::Index>(i), k) = step * levels.at(static_cast<std::size_t>(3 * corners[i] + k));
    }
  }
  return points;
}

TEST(ShapeViewJson, KeepsTheOrderOfTrianglesAndRoundsCoordinates) {
  const Shape mesh = test::permuted(test::torus(3, 1, 40, 20), 1).shape;
  const Json json = shape_view_json({.name = "torus", .shape = mesh});
  ASSERT_EQ(json["triangles"]["count"], mesh.triangles.rows());
  const Points points = corner_points(json);
  ASSERT_EQ(points.rows(), 3 * mesh.triangles.rows());
  const Eigen::RowVector3d low = mesh.vertices.colwise().minCoeff();
  const double step = 8.0 / 65535;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d expected = mesh.vertices.row(mesh.triangles(i / 3, i % 3)) - low;
    ASSERT_LE((points.row(i) - expected).cwiseAbs().maxCoeff(), 0.51 * step) << i;
  }
}

TEST(ShapeViewJson, OmitsUnusedVerticesAndTheirValues) {
  Shape mesh{.vertices = Points{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {5, 5, 5}, {0, 1, 0}},
             .triangles = Triangles{{4, 1, 2}}};
  ShapeView view{.name = "", .shape = mesh, .site = SampleSite::vertices};
  view.fields = {{.name = "f", .values = Eigen::VectorXd{{100, 1, 2, -100, 3}}, .colours = {.low = 1, .high = 3}}};
  const Json json = shape_view_json(view);
  EXPECT_THAT(shorts_of(json["vertices"]["values"]), ElementsAre(0, 65535, 0, 0, 0, 0, 65535, 0, 0));
  EXPECT_EQ(json["fields"][0]["low"], 1);
  EXPECT_EQ(json["fields"][0]["high"], 3);
  EXPECT_THAT(shorts_of(json["fields"][0]["values"]), ElementsAre(65534, 0, 32767));
}

TEST(ShapeViewJson, EncodesMissingValuesAsASeparateLevel) {
  ShapeView view = test_view::balls();
  view.fields.resize(1);
  view.fields[0].values[3] = std::nan("");
  view.fields[0].values[4] = std::numeric_limits<double>::infinity();
  const Json field = shape_view_json(view)["fields"][0];
  const std::vector<int> levels = shorts_of(field["values"]);
  ASSERT_EQ(std::ssize(levels), view.shape.triangles.rows());
  EXPECT_EQ(levels[3], 65535);
  EXPECT_EQ(levels[4], 65535);
  EXPECT_EQ(levels[5], 65534);
  EXPECT_EQ(levels.back(), 0);
  EXPECT_EQ(field["high"], 2);
}

TEST(ShapeViewJson, AxesMatchTheViewingDirectionOfPictures) {
  ShapeView view = test_view::balls();
  view.up = {0, -1, 0};
  const Json axes = shape_view_json(view)["axes"];
  Eigen::Matrix3d rows;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) rows(row, k) = axes[static_cast<std::size_t>(row)][static_cast<std::size_t>(k)];
  }
  EXPECT_NEAR((rows * rows.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-6);
  EXPECT_NEAR(rows.determinant(), 1, 1e-6);
  const RenderOptions look = upright_view(view.shape, {.up = view.up});
  EXPECT_NEAR(rows.row(2).dot(look.towards_viewer.normalized()), 1, 1e-6);
  EXPECT_GT(rows.row(1).dot(look.up), 0);
}

TEST(ShapeViewJson, ContainsPartsAndNormalsIfThereAreAny) {
  const ShapeView view = test_view::balls();
  const Json json = shape_view_json(view);
  const std::vector<int> parts = shorts_of(json["parts"][0]["values"]);
  EXPECT_TRUE(std::equal(parts.begin(), parts.end(), view.parts[0].labels.begin(), view.parts[0].labels.end()));
  EXPECT_EQ(json["fields"][0]["measured"], (Json{{"by", "ball"}, {"unit", 1}}));
  EXPECT_EQ(json["parts"][0]["colours"], (Json{"#c82828", "#2828c8"}));
  // From the middle of the box, whose x is from -1 to 2.25.
  EXPECT_EQ(
      json["regions"],
      Json::array(
          {{{"text", "small <ball>"}, {"position", {1.625, 0.0, 0.0}}, {"towards", {1.0, 0.0, 0.0}}, {"size", 0.5}}}));
  const Bytes directions = bytes_of(json["directions"]);
  ASSERT_EQ(std::ssize(directions), 3 * view.shape.triangles.rows());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double component = view.normals(static_cast<Eigen::Index>(i) / 3, static_cast<Eigen::Index>(i % 3));
    EXPECT_NEAR(static_cast<std::int8_t>(directions[i]) / 127.0, component, 0.5 / 127 + 1e-9);
  }
  const Json bare = shape_view_json({.name = "", .shape = view.shape});
  EXPECT_FALSE(bare.contains("parts") || bare.contains("directions") || bare.contains("radii"));
}

TEST(ShapeViewJson, RadiiOfCloudPointsMatchTheHexagonsInPictures) {
  const ShapeView view = test_view::cloud();
  const Json json = shape_view_json(view);
  EXPECT_FALSE(json.contains("triangles"));
  const std::vector<int> radii = shorts_of(json["radii"]["values"]);
  ASSERT_EQ(radii.size(), 800U);
  const Shape hexagons = splats(view.shape);
  const double step = json["radii"]["step"];
  for (Eigen::Index i = 0; i < 800; ++i) {
    const double radius = (hexagons.vertices.row(6 * i) - view.shape.vertices.row(i)).norm();
    EXPECT_NEAR(step * radii[static_cast<std::size_t>(i)], radius, step) << i;
  }
}

TEST(ShapeViewJson, RejectsShapesWithoutExtent) {
  EXPECT_THROW(
      shape_view_json({.name = "", .shape = {.vertices = Points::Ones(3, 3), .triangles = Triangles{{0, 1, 2}}}}),
      InputError);
}

TEST(CentralValueRange, ExcludesTwoPercentOfTheAreaAtEachEnd) {
  ScalarField field{.values = Eigen::VectorXd::LinSpaced(101, 0, 100), .weights = Eigen::VectorXd::Ones(101)};
  field.values[50] = std::nan("");
  const Interval range = central_range(field).value();
  EXPECT_NEAR(range.low, 2, 1);
  EXPECT_NEAR(range.high, 98, 1);
  field.weights.setZero();
  EXPECT_FALSE(central_range(field).has_value());
}

TEST(ShapeViewPicture, IsSquareWithATransparentBackground) {
  const auto [width, height, pixels] = test::decoded(shape_view_picture(test_view::balls(), 64));
  EXPECT_EQ(width, 64);
  EXPECT_EQ(height, 64);
  ASSERT_EQ(pixels.size(), 4U * 64 * 64);
  EXPECT_EQ(pixels[3], 0);
  int yellow = 0;
  int dark = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    if (pixels[i + 3] < 255) continue;
    ++(pixels[i] > 2 * pixels[i + 2] ? yellow : dark);
  }
  EXPECT_GT(yellow, 10 * dark) << "the ball with 16 times the area of the other one is the thick one";
  EXPECT_GT(dark, 10);
}

TEST(ViewPage, EscapesMarkupInNames) {
  const std::string html = view_page(test_view::page());
  EXPECT_EQ(test::occurrences(html, "</script>"), 3U) << "the libraries, the data, the scripts";
  EXPECT_THAT(html, HasSubstr("<title>Balls &amp; &lt;clouds&gt; "));
  EXPECT_THAT(html, Not(HasSubstr("<b>balls")));
  const auto data = test::json_of_page(html);
  EXPECT_EQ(data["shapes"][0]["name"], test_view::balls().name);
  EXPECT_EQ(data["missing"][0], "broken<i>.off");
}

TEST(ViewPage, LoadsNoExternalResourcesAndHasNoUnfilledPlaceholders) {
  const std::string html = view_page(test_view::page());
  for (const char* word : {" src=\"http", " href=\"http", "@import", "{{title}}", "{{style}}", "{{main}}",
                           "{{libraries}}", "{{data}}", "{{script}}"}) {
    EXPECT_THAT(html, Not(HasSubstr(word)));
  }
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
}

TEST(ViewPage, IsTheSameOnAnyNumberOfThreads) {
  const std::string html = view_page(test_view::page());
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(view_page(test_view::page()) == html);
}

}  // namespace

}  // namespace shapegauge
