#include <gtest/gtest.h>

#include "shapegauge/core/perturbation/vertex_noise.h"
#include "shapegauge/experiments/perturbations/perturbation.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

std::vector<Perturbation> steps_of(const char* text) { return make_perturbations(nlohmann::json::parse(text)); }

Points vertices_of(const char* steps, std::uint64_t seed, const char* id, std::size_t model) {
  return perturb_model(test_shapes::box({1, 2, 3}, 2), steps_of(steps), seed, id, model).shape.vertices;
}

constexpr const char* noise = R"([{"type": "vertex_noise", "amplitude": 0.01}])";

TEST(PerturbModel, DependsOnSeedAndIdButNotOnThePlaceInTheDataSet) {
  EXPECT_EQ(vertices_of(noise, 1, "T3", 3), vertices_of(noise, 1, "T3", 4));
  EXPECT_NE(vertices_of(noise, 1, "T3", 3), vertices_of(noise, 1, "T4", 3));
  EXPECT_NE(vertices_of(noise, 1, "T3", 3), vertices_of(noise, 2, "T3", 3));
}

TEST(PerturbModel, IsTheSameOnEveryMachine) {
  // Of the id, 64-bit FNV-1a.
  RandomNumbers model(7, 0xaf63dc4c8601ec8cULL);  // the hash of "a", by its authors' table
  RandomNumbers step(model.next());
  const Shape box = test_shapes::box({1, 2, 3}, 2);
  EXPECT_EQ(vertices_of(noise, 7, "a", 0), vertex_noise(box, {.amplitude = 0.01}, step).vertices);
}

TEST(PerturbModel, AStepDrawsTheSameWhateverTheStepBeforeItDraws) {
  const char* one_hole = R"([{"type": "flip_orientation", "fraction": 0.5}, {"type": "motion", "scale": 2}])";
  const char* no_hole = R"([{"type": "decimate", "faces": 1000}, {"type": "motion", "scale": 2}])";
  EXPECT_EQ(vertices_of(one_hole, 1, "T3", 0), vertices_of(no_hole, 1, "T3", 0));
}

TEST(PerturbModel, WithoutStepsChangesNothing) {
  const Shape box = test_shapes::box({1, 2, 3}, 2);
  const PerturbedShape same = perturb_model(box, {}, 1, "T3", 0);
  EXPECT_EQ(same.shape.vertices, box.vertices);
  EXPECT_EQ(same.shape.triangles, box.triangles);
  EXPECT_TRUE(same.chosen.empty());
}

}  // namespace
}  // namespace shapegauge
