#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/generator/pose.h"
#include "shapegauge/experiments/generator/skeleton.h"

namespace shapegauge {

/// A class's body in the rest pose, meshed, ready to be posed.
struct ArticulatedBody {
  Skeleton skeleton;
  RestPose rest;
  Triangles triangles;
  Eigen::VectorXi labels;   ///< for each triangle, the limb that it belongs to
  Eigen::MatrixXd weights;  ///< see bone_weights
};

/// Meshes a skeleton's skin with about so many triangles (within a fifth) and attaches it to the bones.
ArticulatedBody make_body(const Skeleton& skeleton, int faces);

/// An individual of the body's class in a pose: proportions drawn at random, then poses until one is free of
/// self-intersections and of degenerate triangles, the range of motion shrinking from draw to draw. Throws
/// std::runtime_error where none of them is.
Shape draw_model(const ArticulatedBody& body, RandomNumbers& random);

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

/// What generate_dataset makes.
struct GeneratorOptions {
  int classes = 16;          ///< the first so many of generated_class_names(); at least 1
  int models_per_class = 8;  ///< each one an individual of its class in a pose of its own; at least 1
  int faces = 4000;          ///< approximate number of triangles of a model; from 1000 to 100000
  std::uint64_t seed = 1;    ///< the same seed and options give the same bytes, whatever the number of threads
  bool force = false;        ///< replace a data set that the folder holds already
};

/// Called after every model with the number of models written so far and in all; one call at a time, from any thread.
using GeneratorProgress = std::function<void(int done, int total)>;

/// Names of the classes the generator knows, in the order in which GeneratorOptions::classes counts them.
std::vector<std::string> generated_class_names();

/// Writes articulated shapes into the folder (made where absent), in the layout of SHREC'11:
/// - T0.off, T1.off, ...: closed, manifold, outward-oriented meshes without self-intersections, one component each;
/// - T0.seg, T1.seg, ...: a part label per triangle, one integer a line, as in the Princeton segmentation benchmark;
/// - test.cla: the classification; the models of a class are scattered over the numbers at random;
/// - parts.json: per class the names of its parts, in the order of the labels.
/// Models are made in parallel (TBB). Throws InputError: an option out of range, a folder that cannot be written, a
/// folder that holds T*.off, T*.seg or test.cla already (unless forced: then those are replaced or removed).
void generate_dataset(const std::filesystem::path& folder, const GeneratorOptions& options,
                      const GeneratorProgress& progress = {});

}  // namespace shapegauge
