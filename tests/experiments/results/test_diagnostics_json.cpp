#include <gtest/gtest.h>

#include "shapegauge/experiments/results/diagnostics_json.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

TEST(DiagnosticsJson, NamesEveryDiagnostic) {
  Shape box = test_shapes::box({1, 1, 1}, 1);
  box.triangles = box.triangles.topRows(11).eval();
  const nlohmann::ordered_json json = diagnostics_json(diagnose(box));
  EXPECT_EQ(json["closed"], false);
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["triangles"], 11);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["boundary_edges"], 3);
  EXPECT_EQ(json["edges"], 18);
  EXPECT_DOUBLE_EQ(json["boundary_length"], 2 + std::sqrt(2));
  EXPECT_DOUBLE_EQ(json["boundary_fraction"], (2 + std::sqrt(2)) / std::sqrt(3));
}

TEST(DiagnosticsJson, AnEmptyShapeHasNoFractionThatIsNotANumber) {
  EXPECT_EQ(diagnostics_json(diagnose(Shape{}))["boundary_fraction"], 0);
}

}  // namespace
}  // namespace shapegauge
