// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gtest/gtest.h>
#include <set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/perturbation/sample_points.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Settings = std::vector<std::pair<std::string_view, ParameterValue>>;

Shape applied(std::string_view name, const Settings& settings, const Shape& shape) {
  const ShapePerturbation& entry = shape_perturbations().at(name);
  ParameterValues values(entry.parameters);
  for (const auto& [parameter, value] : settings) values.set(parameter, value);
  values.require_complete();
  RandomNumbers random(7);
  return entry.apply(shape, values, random);
}

const Shape sphere = test::sphere(1, 3);

/// Each entry calls its function with each setting as the right argument.
TEST(ShapePerturbations, PassTheirParametersToTheMatchingLibraryFunction) {
  const auto expect_same = [](const Shape& a, const Shape& b) {
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.normals, b.normals);
  };
  const auto with_random = [](auto change) {
    RandomNumbers random(7);
    return change(random);
  };
  using namespace std::string_view_literals;
  expect_same(applied("vertex_noise", {{"amplitude", 0.1}, {"distribution", "gaussian"sv}}, sphere),
              with_random([](RandomNumbers& random) {
                return vertex_noise(sphere, {.amplitude = 0.1, .distribution = NoiseDistribution::gaussian}, random);
              }));
  expect_same(applied("vertex_noise", {{"amplitude", 0.1}}, sphere), with_random([](RandomNumbers& random) {
                return vertex_noise(sphere, {.amplitude = 0.1, .distribution = NoiseDistribution::uniform}, random);
              }));
  expect_same(applied("remove_faces", {{"fraction", 0.3}}, sphere),
              with_random([](RandomNumbers& random) { return remove_faces(sphere, 0.3, random); }));
  expect_same(applied("holes", {{"number", 2}, {"radius", 0.1}}, sphere), with_random([](RandomNumbers& random) {
                return punch_holes(sphere, {.number = 2, .radius = 0.1}, random);
              }));
  expect_same(applied("holes", {}, sphere),
              with_random([](RandomNumbers& random) { return punch_holes(sphere, {}, random); }));
  expect_same(applied("decimate", {{"faces", 500}}, sphere), decimate(sphere, 500));
  expect_same(applied("sample_points", {{"points", 50}, {"with_normals", true}}, sphere),
              with_random([](RandomNumbers& random) {
                return sample_points(sphere, {.points = 50, .with_normals = true}, random);
              }));
  expect_same(applied("vertex_cloud", {}, sphere), vertex_cloud(sphere));
  expect_same(applied("flip_orientation", {{"fraction", 0.25}}, sphere),
              with_random([](RandomNumbers& random) { return flip_orientation(sphere, 0.25, random); }));
  expect_same(applied("flip_orientation", {}, sphere),
              with_random([](RandomNumbers& random) { return flip_orientation(sphere, 1, random); }));
  expect_same(applied("motion", {{"scale", 3.0}}, sphere),
              with_random([](RandomNumbers& random) { return random_motion(sphere, 3, random); }));
}

TEST(ShapePerturbations, HaveUniqueNamesAndDescriptions) {
  std::set<std::string_view> names;
  for (const ShapePerturbation& entry : shape_perturbations().entries()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.description.empty()) << entry.name;
    std::set<std::string_view> of_parameters;
    for (const Parameter& parameter : entry.parameters) {
      EXPECT_TRUE(of_parameters.insert(parameter.name).second) << parameter.name;
      EXPECT_FALSE(parameter.description.empty()) << entry.name << " " << parameter.name;
      if (!parameter.required()) {
        EXPECT_EQ(validate_value(parameter, parameter.default_value), parameter.default_value) << parameter.name;
      }
    }
  }
}

/// Registry and function accept the same parameters.
TEST(ShapePerturbations, RejectParametersOutOfBounds) {
  RandomNumbers random(1);
  const Shape small = test::box({1, 1, 1}, 1);
  EXPECT_THROW(applied("vertex_noise", {{"amplitude", 1.001}}, small), InputError);
  EXPECT_THROW(vertex_noise(small, {.amplitude = 1.001}, random), InputError);
  EXPECT_NO_THROW(vertex_noise(small, {.amplitude = 1}, random));
  EXPECT_THROW(applied("holes", {{"number", 100'001}}, small), InputError);
  EXPECT_THROW(punch_holes(small, {.number = 100'001}, random), InputError);
  EXPECT_THROW(applied("motion", {{"scale", 1'000'001}}, small), InputError);
  EXPECT_THROW(random_motion(small, 1'000'001, random), InputError);
  EXPECT_NO_THROW(random_motion(small, 1'000'000, random));
  EXPECT_THROW(applied("decimate", {{"faces", 0}}, small), InputError);
  EXPECT_THROW(decimate(small, 0), InputError);
  EXPECT_THROW(decimate(small, 100'000'001), InputError);
  EXPECT_THROW(sample_points(small, {.points = 100'000'001}, random), InputError);
}

constexpr std::array stretch_parameters{Parameter{.name = "factor",
                                                  .default_value = 2.0,
                                                  .bounds = {.low = 0, .low_open = true},
                                                  .description = "Of the stretch along x."}};

/// Minimal perturbation as a user of the library would add it.
TEST(RegisterShapePerturbation, MakesAUserDefinedPerturbationAvailableByName) {
  shape_perturbations().add({.name = "test_stretch",
                             .description = "Stretched along x.",
                             .parameters = stretch_parameters,
                             .apply = [](Shape shape, const ParameterValues& settings, RandomNumbers& /*random*/) {
                               shape.vertices.col(0) *= settings.number("factor");
                               return shape;
                             }});
  EXPECT_EQ(applied("test_stretch", {}, sphere).vertices.col(0), 2 * sphere.vertices.col(0));
  EXPECT_EQ(applied("test_stretch", {{"factor", 3}}, sphere).vertices.col(0), 3 * sphere.vertices.col(0));
  EXPECT_THROW(applied("test_stretch", {{"factor", 0}}, sphere), InputError);
  EXPECT_THROW(shape_perturbations().add({.name = "test_none", .description = "", .parameters = {}, .apply = nullptr}),
               ArgumentError);
}

}  // namespace
}  // namespace shapegauge
