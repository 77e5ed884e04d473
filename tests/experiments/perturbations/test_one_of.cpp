#include <array>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/experiments/perturbations/one_of.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

using Json = nlohmann::json;

/// Nothing, 24 faces, or a cloud of 50 points.
Json choices() {
  return Json::parse(R"([[], [{"type": "remove_faces", "fraction": 0.5}], [{"type": "sample_points", "points": 50}]])");
}

PerturbedShape perturbed(const std::string& assign, const std::string& id, std::size_t model) {
  const Json step{{"type", "one_of"}, {"assign", assign}, {"choices", choices()}};
  return perturb_model(test_shapes::box({1, 1, 1}, 2), make_perturbations(Json::array({step})), 1, id, model);
}

TEST(OneOf, InTurnGoesByTheModelsPlace) {
  for (std::size_t model = 0; model < 7; ++model) {
    const PerturbedShape result = perturbed("in_turn", "T3", model);
    EXPECT_EQ(result.chosen, std::vector{model % 3});
    EXPECT_EQ(result.shape.triangles.rows(), (std::array{48, 24, 0})[model % 3]);
  }
}

TEST(OneOf, AtRandomChoosesAllAlikeByTheId) {
  std::array<int, 3> times{};
  for (std::size_t i = 0; i < 3000; ++i) {
    const PerturbedShape result = perturbed("random", "T" + std::to_string(i), 0);
    ASSERT_EQ(result.chosen.size(), 1U);
    ++times.at(result.chosen[0]);
  }
  // Standard deviation 26; five of them.
  for (const int t : times) EXPECT_NEAR(t, 1000, 130);
  EXPECT_EQ(perturbed("random", "T3", 0).chosen, perturbed("random", "T3", 5).chosen);
}

TEST(OneOf, MayHoldAnother) {
  const Json inner{{"type", "one_of"}, {"assign", "in_turn"}, {"choices", choices()}};
  const Json outer{{"type", "one_of"}, {"assign", "in_turn"}, {"choices", {Json::array(), Json::array({inner})}}};
  const PerturbedShape result =
      perturb_model(test_shapes::box({1, 1, 1}, 2), make_perturbations(Json::array({outer})), 1, "T3", 5);
  EXPECT_EQ(result.chosen, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(result.shape.vertices.rows(), 50);
}

TEST(OneOf, FillsInTheDefaultsOfItsChoices) {
  const Json settings = one_of_step(Json{{"type", "one_of"}, {"choices", choices()}}).settings;
  EXPECT_EQ(settings["assign"], "random");
  EXPECT_EQ(settings["choices"][0], Json::array());
  EXPECT_EQ(settings["choices"][2][0]["with_normals"], false);
}

}  // namespace
}  // namespace shapegauge
