#include <gmock/gmock.h>

#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/flip_orientation.h"
#include "shapegauge/core/perturbation/punch_holes.h"
#include "shapegauge/core/perturbation/random_motion.h"
#include "shapegauge/core/perturbation/remove_faces.h"
#include "shapegauge/core/perturbation/sample_surface.h"
#include "shapegauge/core/perturbation/vertex_noise.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"
#include "tests/core/test_shapes.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

/// Expects that the step is what the function of the core does, and that its settings make the same step again.
template <typename OfTheCore>
void expect_step(const Json& settings, const OfTheCore& of_the_core) {
  const Shape sphere = test_shapes::sphere(1, 3);
  RandomNumbers random(5);
  const Shape expected = of_the_core(sphere, random);
  for (const Perturbation& step :
       {make_perturbation(settings), make_perturbation(make_perturbation(settings).settings)}) {
    PerturbationContext context{.random = RandomNumbers(5)};
    const Shape shape = step.apply(sphere, context);
    EXPECT_EQ(shape.vertices, expected.vertices) << settings;
    EXPECT_EQ(shape.triangles, expected.triangles) << settings;
    EXPECT_EQ(shape.normals, expected.normals) << settings;
    EXPECT_EQ(step.settings.at("type"), settings.at("type"));
  }
}

TEST(MakePerturbation, StepsAreTheFunctionsOfTheCore) {
  expect_step({{"type", "vertex_noise"}, {"amplitude", 0.02}},
              [](const Shape& s, RandomNumbers& r) { return vertex_noise(s, {.amplitude = 0.02}, r); });
  expect_step({{"type", "vertex_noise"}, {"amplitude", 0.02}, {"distribution", "uniform"}},
              [](const Shape& s, RandomNumbers& r) {
                return vertex_noise(s, {.amplitude = 0.02, .distribution = NoiseDistribution::uniform}, r);
              });
  expect_step({{"type", "remove_faces"}, {"fraction", 0.3}},
              [](const Shape& s, RandomNumbers& r) { return remove_faces(s, 0.3, r); });
  expect_step({{"type", "holes"}, {"number", 3}, {"radius", 0.1}},
              [](const Shape& s, RandomNumbers& r) { return punch_holes(s, {.number = 3, .radius = 0.1}, r); });
  expect_step({{"type", "decimate"}, {"faces", 200}}, [](const Shape& s, RandomNumbers&) { return decimate(s, 200); });
  expect_step(
      {{"type", "sample_points"}, {"points", 70}, {"with_normals", true}},
      [](const Shape& s, RandomNumbers& r) { return sample_surface(s, {.points = 70, .with_normals = true}, r); });
  expect_step({{"type", "flip_orientation"}, {"fraction", 0.5}},
              [](const Shape& s, RandomNumbers& r) { return flip_orientation(s, 0.5, r); });
  expect_step({{"type", "motion"}, {"scale", 10}},
              [](const Shape& s, RandomNumbers& r) { return random_motion(s, 10, r); });
}

TEST(MakePerturbation, FillsInDefaults) {
  EXPECT_EQ(to_json(make_perturbations(Json::parse(R"([{"type": "holes"}, {"type": "flip_orientation"}])"))),
            Json::parse(
                R"([{"type": "holes", "number": 5, "radius": 0.05}, {"type": "flip_orientation", "fraction": 1.0}])"));
}

TEST(MakePerturbation, AnUnknownTypeIsAnError) {
  EXPECT_THAT(input_error_of([] {
                make_perturbation({{"type", "melt"}});
              }),
              HasSubstr("no perturbation of type \"melt\""));
}

}  // namespace
}  // namespace shapegauge
