#include "shapegauge/experiments/generator/generate_model.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/generator/classes/class_skeletons.h"
#include "shapegauge/experiments/generator/generate_dataset.h"

namespace shapegauge {

Shape draw_numbered_model(const ArticulatedBody& body, std::size_t class_index, std::size_t model, std::uint64_t seed) {
  RandomNumbers random(seed, (class_index << 32U) + model);
  return draw_model(body, random);
}

Shape generate_model(const GeneratedModel& wanted) {
  const std::vector<std::string> classes = generated_class_names();
  const auto found = std::ranges::find(classes, wanted.model_class);
  if (found == classes.end()) throw InputError(fmt::format("there is no class \"{}\" to generate", wanted.model_class));
  if (wanted.model < 0 || wanted.faces < 1000 || wanted.faces > 100000) {
    throw InputError(
        fmt::format("cannot generate model {} with {} faces; choose a model from 0 and 1000 to 100000 faces",
                    wanted.model, wanted.faces));
  }
  const auto class_index = static_cast<std::size_t>(found - classes.begin());
  const ArticulatedBody body = make_body(class_skeleton(class_index), wanted.faces);
  return draw_numbered_model(body, class_index, static_cast<std::size_t>(wanted.model), wanted.seed);
}

}  // namespace shapegauge
