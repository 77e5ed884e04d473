#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/segmentation/paper_segmentation.h"
#include "tests/segmentation/dumbbell.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

ScalarField offset_field(const Shape& shape, const SurfaceGraph& graph) {
  return {offset_sdf(shape, graph.samples, {}).values, graph.samples.weights};
}

TEST(PaperSegmentation, TellsTheBarOfADumbbellFromItsBalls) {
  const Shape shape = test::dumbbell(4);
  const SurfaceGraph graph = surface_graph(shape);
  const std::vector<ScalarField> fields = {offset_field(shape, graph)};
  const std::vector<std::int32_t> parts = paper_segmentation(graph, fields, {.mixture = {.components = 2}});
  std::set<std::int32_t> low;
  std::set<std::int32_t> bar;
  std::set<std::int32_t> high;
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    const double z = graph.samples.points(i, 2);
    if (z < -2.2) low.insert(parts[static_cast<std::size_t>(i)]);
    if (std::abs(z) < 0.8) bar.insert(parts[static_cast<std::size_t>(i)]);
    if (z > 2.2) high.insert(parts[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(low.size(), 1U);
  EXPECT_EQ(bar.size(), 1U);
  EXPECT_EQ(high.size(), 1U);
  EXPECT_NE(low, bar);
  EXPECT_NE(high, bar);
  EXPECT_NE(low, high);  // of one cluster, but not connected
}

TEST(PaperSegmentation, OfASphereIsOnePart) {
  const Shape shape = test::sphere(1, 3);
  const SurfaceGraph graph = surface_graph(shape);
  const std::vector<ScalarField> fields = {{Eigen::VectorXd::Constant(graph.size(), 2), graph.samples.weights}};
  const std::vector<std::int32_t> parts = paper_segmentation(graph, fields, {});
  EXPECT_EQ(std::set(parts.begin(), parts.end()).size(), 1U);
}

TEST(PaperSegmentation, RefusesOptionsOutOfRange) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 1));
  const std::vector<ScalarField> fields = {{Eigen::VectorXd::Constant(graph.size(), 2), graph.samples.weights}};
  EXPECT_THROW(paper_segmentation(graph, fields, {.smoothness = -1}), InputError);
  EXPECT_THROW(paper_segmentation(graph, fields, {.levels = 0}), InputError);
}

}  // namespace
}  // namespace shapegauge
