#include "shapegauge/experiments/comparison/comparison.h"

#include "shapegauge/experiments/configuration/preparation_settings.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

Json to_json(const GeneratedModel& generated) {
  return {{"class", generated.model_class},
          {"model", generated.model},
          {"faces", generated.faces},
          {"seed", generated.seed}};
}

Json to_json(const ComparedShape& shape) {
  Json json{{"name", shape.name}, {"perturbations", to_json(shape.perturbations)}};
  if (shape.generated) {
    json["generate"] = to_json(*shape.generated);
  } else {
    json["file"] = std::filesystem::absolute(shape.file).lexically_normal().string();
  }
  return json;
}

}  // namespace

Json to_json(const Comparison& comparison) {
  Json json{{"name", comparison.name},
            {"seed", comparison.seed},
            {"preparation", to_json(comparison.preparation)},
            {"on_error", comparison.on_error == OnError::stop ? "stop" : "skip"},
            {"signatures", to_json(comparison.signatures)},
            {"distance", comparison.distance}};
  for (const ComparedShape& shape : comparison.shapes) json["shapes"].push_back(to_json(shape));
  if (!comparison.description.empty()) json["description"] = comparison.description;
  if (comparison.reference) {
    json["reference"] = comparison.shapes[*comparison.reference].name;
    json["registered"] = comparison.registered;
  }
  return json;
}

}  // namespace shapegauge
