#pragma once

#include <cstdint>
#include <string>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/generator/articulated_body.h"

namespace shapegauge {

/// One model of a data set that generate_dataset makes with the same number of faces and the same seed.
struct GeneratedModel {
  std::string model_class;  ///< a name of generated_class_names()
  int model = 0;            ///< which of its class, from 0
  int faces = 4000;         ///< approximate number of triangles; from 1000 to 100000
  std::uint64_t seed = 1;
};

/// Makes the model. Throws InputError for a class that is not known and an option out of range.
Shape generate_model(const GeneratedModel& wanted);

/// Draws that model of a class's body, by the class's index in generated_class_names(): an individual in a pose.
Shape draw_numbered_model(const ArticulatedBody& body, std::size_t class_index, std::size_t model, std::uint64_t seed);

}  // namespace shapegauge
