// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of generated models; increment when they change.
inline constexpr int generator_version = 1;

/// Request for one model of the data set that generate_dataset() makes with the same number of faces and seed.
struct GeneratedModel {
  std::string model_class;  ///< class name, one of the choices of generated_model_parameters()
  int model = 0;            ///< index of the model within its class, from 0
  int faces = 4000;         ///< approximate number of triangles
  std::uint64_t seed = 1;   ///< seed of the data set
};

/// Generates one model of a data set. Throws InputError for an unknown class and an option out of range.
Shape generate_model(const GeneratedModel& request);

/// Options of generate_dataset().
struct GeneratorOptions {
  int classes = 16;          ///< number of classes: the first choices of generated_model_parameters()
  int models_per_class = 8;  ///< number of models per class: individuals in random poses, or random objects
  int faces = 4000;          ///< approximate number of triangles of a model
  std::uint64_t seed = 1;    ///< random seed; equal options give equal bytes for any number of threads
  bool replace = false;      ///< true to replace an existing data set in the folder
};

/// Returns the option table of the members of GeneratorOptions except `replace`.
const std::array<OptionParameter<GeneratorOptions>, 4>& generator_table();

/// Return the parameters of GeneratorOptions (except `replace`) and of GeneratedModel. The parameter of model_class is
/// named `class`.
/// @{
std::span<const Parameter> generator_parameters();        ///< parameters of GeneratorOptions
std::span<const Parameter> generated_model_parameters();  ///< parameters of GeneratedModel
/// @}

/// Callback after every model, with the numbers of models written so far and in total; serialised, from any thread.
using GeneratorProgress = std::function<void(int done, int total)>;

/// Writes articulated shapes and, after their classes, rigid objects into a folder (created if missing), in the layout
/// of SHREC'11.
/// - T0.off, T1.off, ...: closed, manifold, outward-oriented meshes without self-intersections, one component each; z
///   is up, as a comment at the end states (up_comment).
/// - T0.seg, T1.seg, ...: a part label per triangle, one integer per line, as in the Princeton segmentation benchmark.
/// - test.cla: the classification; the model numbers are randomly permuted.
/// - parts.json: per class the names of its parts, in the order of labels; an object may lack some.
///
/// Models are generated in parallel (TBB). Throws InputError for an option out of range, a folder that cannot be
/// written, and a folder that already has T*.off, T*.seg or test.cla (with `replace`, these are replaced or removed).
void generate_dataset(const std::filesystem::path& folder, const GeneratorOptions& options,
                      const GeneratorProgress& progress = {});

}  // namespace shapegauge
