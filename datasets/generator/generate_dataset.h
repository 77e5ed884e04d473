#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// One model of a data set that generate_dataset makes with the same number of faces and the same seed.
struct GeneratedModel {
  std::string model_class;  ///< a choice of generated_model_parameters()
  int model = 0;            ///< which of its class, from 0
  int faces = 4000;         ///< approximate number of triangles
  std::uint64_t seed = 1;
};

/// Makes the model. Throws InputError for a class that is not known and an option out of range.
Shape generate_model(const GeneratedModel& wanted);

/// What generate_dataset makes.
struct GeneratorOptions {
  int classes = 16;          ///< the first so many choices of generated_model_parameters()
  int models_per_class = 8;  ///< each one an individual of its class in a pose of its own, or an object
  int faces = 4000;          ///< approximate number of triangles of a model
  std::uint64_t seed = 1;    ///< the same seed and options give the same bytes, whatever the number of threads
  bool force = false;        ///< replace a data set that the folder holds already
};

/// The options as parameters, with their legal values: those of GeneratorOptions but `force`, and those of
/// GeneratedModel, whose class is `class`.
std::span<const Parameter> generator_parameters();
std::span<const Parameter> generated_model_parameters();

/// Called after every model with the number of models written so far and in all; one call at a time, from any thread.
using GeneratorProgress = std::function<void(int done, int total)>;

/// Writes articulated shapes and, after their classes, rigid objects into the folder (made where absent), in the layout
/// of SHREC'11:
/// - T0.off, T1.off, ...: closed, manifold, outward-oriented meshes without self-intersections, one component each;
/// - T0.seg, T1.seg, ...: a part label per triangle, one integer a line, as in the Princeton segmentation benchmark;
/// - test.cla: the classification; the models of a class are scattered over the numbers at random;
/// - parts.json: per class the names of its parts, in the order of the labels; an object may lack some.
/// Models are made in parallel (TBB). Throws InputError: an option out of range, a folder that cannot be written, a
/// folder that holds T*.off, T*.seg or test.cla already (unless forced: then those are replaced or removed).
void generate_dataset(const std::filesystem::path& folder, const GeneratorOptions& options,
                      const GeneratorProgress& progress = {});

}  // namespace shapegauge
