#include "shapegauge/experiments/perturbations/perturbation.h"

#include <utility>

namespace shapegauge {

namespace {

/// 64-bit FNV-1a: the same number everywhere, which std::hash does not promise.
std::uint64_t stable_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

Shape apply_perturbations(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& parent) {
  for (const Perturbation& step : steps) {
    PerturbationContext own{
        .random = RandomNumbers(parent.random.next()), .model = parent.model, .chosen = parent.chosen};
    shape = step.apply(std::move(shape), own);
  }
  return shape;
}

PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model) {
  PerturbedShape perturbed;
  PerturbationContext context{
      .random = RandomNumbers(seed, stable_hash(id)), .model = model, .chosen = &perturbed.chosen};
  perturbed.shape = apply_perturbations(std::move(shape), steps, context);
  return perturbed;
}

}  // namespace shapegauge
