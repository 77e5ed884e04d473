#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// To be raised with every change of what any perturbation makes of a shape: what a cache holds of earlier versions is
/// then computed anew.
inline constexpr int perturbations_version = 1;

/// What a perturbation may depend on besides the shape.
struct PerturbationContext {
  RandomNumbers random;                        ///< a stream of the step's own
  std::size_t model = 0;                       ///< the model's index in the data set
  std::vector<std::size_t>* chosen = nullptr;  ///< where steps that choose append what they chose
};

/// A step that a configuration asks for: how shapes are changed before anything is computed of them.
struct Perturbation {
  nlohmann::json settings;  ///< type and all settings, defaults filled in
  std::function<Shape(Shape, PerturbationContext&)> apply;
};

/// Applies the steps one after the other. Each has a stream of its own, which the parent's next number seeds: what one
/// step draws does not change what the others do.
Shape apply_perturbations(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& parent);

/// A model's shape after the steps.
struct PerturbedShape {
  Shape shape;
  std::vector<std::size_t> chosen;  ///< by step that chooses, in order of application: the index of its choice
};

/// Applies the steps to a model. What is drawn depends on the seed and the model's id only, not on the other models.
PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model);

}  // namespace shapegauge
