#include "shapegauge/experiments/perturbations/one_of.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "shapegauge/experiments/perturbations/perturbation_registry.h"

namespace shapegauge {

Perturbation one_of_step(const nlohmann::json& settings) {
  const bool in_turn = settings.value("assign", "random") == "in_turn";
  std::vector<std::vector<Perturbation>> choices;
  nlohmann::json filled_in = nlohmann::json::array();
  for (const nlohmann::json& choice : settings.at("choices")) {
    filled_in.push_back(to_json(choices.emplace_back(make_perturbations(choice))));
  }
  return {.settings = {{"type", "one_of"}, {"assign", in_turn ? "in_turn" : "random"}, {"choices", filled_in}},
          .apply = [in_turn, choices = std::move(choices)](Shape shape, PerturbationContext& context) {
            const auto drawn = static_cast<std::size_t>(context.random.uniform(0, static_cast<double>(choices.size())));
            const std::size_t choice = in_turn ? context.model % choices.size() : std::min(drawn, choices.size() - 1);
            context.chosen->push_back(choice);
            return apply_perturbations(std::move(shape), choices[choice], context);
          }};
}

}  // namespace shapegauge
