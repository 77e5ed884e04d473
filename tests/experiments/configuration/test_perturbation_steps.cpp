// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/perturbation/sample_points.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

std::vector<Perturbation> steps_of(const char* text) { return make_perturbations(nlohmann::json::parse(text)); }

Points vertices_of(const char* steps, std::uint64_t seed, const char* id, std::size_t model) {
  return perturb_model(test::box({1, 2, 3}, 2), steps_of(steps), seed, id, model).shape.vertices;
}

constexpr const char* noise = R"([{"type": "vertex_noise", "amplitude": 0.01}])";

TEST(PerturbModel, DependsOnTheSeedAndModelIdButNotOnTheIndex) {
  EXPECT_EQ(vertices_of(noise, 1, "T3", 3), vertices_of(noise, 1, "T3", 4));
  EXPECT_NE(vertices_of(noise, 1, "T3", 3), vertices_of(noise, 1, "T4", 3));
  EXPECT_NE(vertices_of(noise, 1, "T3", 3), vertices_of(noise, 2, "T3", 3));
}

TEST(PerturbModel, SeedsRandomNumbersByTheHashOfTheModelId) {
  // Seeded by the id's 64-bit FNV-1a hash.
  RandomNumbers model(7, 0xaf63dc4c8601ec8cULL);  // published hash of "a"
  RandomNumbers step(model.next());
  const Shape box = test::box({1, 2, 3}, 2);
  EXPECT_EQ(vertices_of(noise, 7, "a", 0), vertex_noise(box, {.amplitude = 0.01}, step).vertices);
}

TEST(PerturbModel, UsesIndependentRandomNumbersPerStep) {
  const char* one_hole = R"([{"type": "flip_orientation", "fraction": 0.5}, {"type": "motion", "scale": 2}])";
  const char* no_hole = R"([{"type": "decimate", "faces": 1000}, {"type": "motion", "scale": 2}])";
  EXPECT_EQ(vertices_of(one_hole, 1, "T3", 0), vertices_of(no_hole, 1, "T3", 0));
}

TEST(PerturbModel, RemarksOnADecimationThatMissesTheRequestedFaceCount) {
  const Shape box = test::box({1, 2, 3}, 2);
  const auto remarks_of = [&](const char* steps) { return perturb_model(box, steps_of(steps), 1, "T3", 0).remarks; };
  EXPECT_TRUE(remarks_of(R"([{"type": "decimate", "faces": 40}])").empty());
  const auto left = decimate(box, 1).triangles.rows();
  ASSERT_GT(left, 1);
  const std::string remark = "decimated to " + std::to_string(left) + " faces instead of 1: no valid collapse is left";
  EXPECT_THAT(remarks_of(R"([{"type": "decimate", "faces": 1}, {"type": "sample_points", "points": 9}])"),
              testing::ElementsAre(remark));
  EXPECT_THAT(remarks_of(R"([{"type": "one_of", "choices": [[{"type": "decimate", "faces": 1}]]}])"),
              testing::ElementsAre(remark));
}

TEST(PerturbModel, KeepsTheShapeUnchangedWithoutSteps) {
  const Shape box = test::box({1, 2, 3}, 2);
  const PerturbedShape same = perturb_model(box, {}, 1, "T3", 0);
  EXPECT_EQ(same.shape.vertices, box.vertices);
  EXPECT_EQ(same.shape.triangles, box.triangles);
  EXPECT_TRUE(same.chosen.empty());
}

using Json = nlohmann::json;

/// Empty shape, mesh of 24 faces, or cloud of 50 points.
Json choices() {
  return Json::parse(R"([[], [{"type": "remove_faces", "fraction": 0.5}], [{"type": "sample_points", "points": 50}]])");
}

PerturbedShape perturbed(const std::string& assign, const std::string& id, std::size_t model) {
  const Json step{{"type", "one_of"}, {"assign", assign}, {"choices", choices()}};
  return perturb_model(test::box({1, 1, 1}, 2), make_perturbations(Json::array({step})), 1, id, model);
}

TEST(OneOfPerturbations, AssignedInTurnFollowTheModelIndex) {
  for (std::size_t model = 0; model < 7; ++model) {
    const PerturbedShape result = perturbed("in_turn", "T3", model);
    EXPECT_EQ(result.chosen, std::vector{model % 3});
    EXPECT_EQ(result.shape.triangles.rows(), (std::array{48, 24, 0})[model % 3]);
  }
}

TEST(OneOfPerturbations, AssignedAtRandomAreUniformAndDependOnTheModelId) {
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

TEST(OneOfPerturbations, CanBeNested) {
  const Json inner{{"type", "one_of"}, {"assign", "in_turn"}, {"choices", choices()}};
  const Json outer{{"type", "one_of"}, {"assign", "in_turn"}, {"choices", {Json::array(), Json::array({inner})}}};
  const PerturbedShape result =
      perturb_model(test::box({1, 1, 1}, 2), make_perturbations(Json::array({outer})), 1, "T3", 5);
  EXPECT_EQ(result.chosen, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(result.shape.vertices.rows(), 50);
}

TEST(OneOfPerturbations, FillInTheDefaultSettingsOfEachChoice) {
  const Json settings = to_json(make_perturbations({{{"type", "one_of"}, {"choices", choices()}}})).front();
  EXPECT_EQ(settings["assign"], "random");
  EXPECT_EQ(settings["choices"][0], Json::array());
  EXPECT_EQ(settings["choices"][2][0]["with_normals"], false);
}

/// Checks that the step equals the function of the core, and that its settings reproduce it.
template <typename OfTheCore>
void expect_step(const Json& settings, const OfTheCore& of_the_core) {
  const Shape sphere = test::sphere(1, 3);
  RandomNumbers model(5, 0xcbf29ce484222325ULL);  // 64-bit FNV-1a hash of the empty id
  RandomNumbers random(model.next());
  const Shape expected = of_the_core(sphere, random);
  const std::vector<Perturbation> read = make_perturbations(Json::array({settings}));
  for (const std::vector<Perturbation>& steps : {read, make_perturbations(to_json(read))}) {
    const Shape shape = perturb_model(sphere, steps, 5, "", 0).shape;
    EXPECT_EQ(shape.vertices, expected.vertices) << settings;
    EXPECT_EQ(shape.triangles, expected.triangles) << settings;
    EXPECT_EQ(shape.normals, expected.normals) << settings;
    EXPECT_EQ(to_json(steps)[0].at("type"), settings.at("type"));
  }
}

TEST(MakePerturbation, AppliesTheLibraryFunctionOfEachStep) {
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
      [](const Shape& s, RandomNumbers& r) { return sample_points(s, {.points = 70, .with_normals = true}, r); });
  expect_step({{"type", "flip_orientation"}, {"fraction", 0.5}},
              [](const Shape& s, RandomNumbers& r) { return flip_orientation(s, 0.5, r); });
  expect_step({{"type", "motion"}, {"scale", 10}},
              [](const Shape& s, RandomNumbers& r) { return random_motion(s, 10, r); });
}

TEST(MakePerturbation, FillsInDefaultsOfOmittedSettings) {
  EXPECT_EQ(to_json(make_perturbations(Json::parse(R"([{"type": "holes"}, {"type": "flip_orientation"}])"))),
            Json::parse(
                R"([{"type": "holes", "number": 5, "radius": 0.05}, {"type": "flip_orientation", "fraction": 1.0}])"));
}

TEST(MakePerturbation, ListsTheAlgorithmVersionsOfAllNestedSteps) {
  using Versions = std::map<std::string, int>;
  EXPECT_EQ(versions_of(steps_of(R"([{"type": "holes"}])")), (Versions{{"holes", 1}}));
  const Json inner{{"type", "one_of"}, {"choices", {Json::array({{{"type", "motion"}}})}}};
  const Json outer{{"type", "one_of"}, {"choices", {Json::array({{{"type", "holes"}}}), Json::array({inner})}}};
  EXPECT_EQ(versions_of(make_perturbations(Json::array({outer}))),
            (Versions{{"one_of", 1}, {"holes", 1}, {"motion", 1}}));
}

}  // namespace

}  // namespace shapegauge
