#include "shapegauge/experiments/generator/generate_dataset.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <stdexcept>
#include <system_error>
#include <tbb/parallel_for.h>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/off.h"
#include "shapegauge/experiments/files/classification.h"
#include "shapegauge/experiments/generator/class_skeletons.h"
#include "shapegauge/experiments/generator/implicit_surface.h"
#include "shapegauge/experiments/generator/mesh_implicit_surface.h"
#include "shapegauge/experiments/generator/pose.h"
#include "shapegauge/experiments/generator/skeleton.h"

namespace shapegauge {

namespace {

// Whether a triangle is a thousand times longer than high.
bool has_degenerate_triangle(const Shape& shape) {
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(f, 2));
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if ((b - a).cross(c - a).norm() <= 1e-3 * longest) return true;
  }
  return false;
}

}  // namespace

ArticulatedBody make_body(const Skeleton& skeleton, int faces) {
  const ImplicitSurface surface(skeleton);
  const Shape mesh = mesh_implicit_surface(surface, faces);
  ArticulatedBody body;
  body.skeleton = skeleton;
  body.rest = {mesh.vertices, bones_of(skeleton)};
  body.triangles = mesh.triangles;
  body.weights = bone_weights(mesh, surface, body.rest.tree);
  body.labels = limb_labels(mesh, body.weights, body.rest.tree);
  return body;
}

Shape draw_model(const ArticulatedBody& body, RandomNumbers& random) {
  constexpr int attempts = 60;
  constexpr double shrinkage = 0.96;
  const RestPose individual = draw_individual(body.skeleton, body.rest, body.weights, random);
  double amplitude = 1;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const std::vector<RigidMotion> motions = draw_pose(body.skeleton, individual.tree, amplitude, random);
    Shape model{skinned(individual.points, body.weights, motions), body.triangles};
    if (!has_degenerate_triangle(model) && !self_intersects(model)) return model;
    amplitude *= shrinkage;
  }
  throw std::runtime_error("no pose of the generated class " + body.skeleton.name + " is free of self-intersections");
}

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

namespace {

void check_option(const char* name, int value, int least, int most) {
  if (value >= least && value <= most) return;
  throw InputError(
      fmt::format("cannot generate a data set with {} = {}; choose from {} to {}", name, value, least, most));
}

void check_options(const GeneratorOptions& options) {
  check_option("classes", options.classes, 1, static_cast<int>(class_count()));
  check_option("models per class", options.models_per_class, 1, 1000);
  check_option("faces", options.faces, 1000, 100000);
}

bool belongs_to_dataset(const std::filesystem::path& file) {
  static const std::regex names(R"(T\d+\.(off|seg)|test\.cla|parts\.json)");
  return std::regex_match(file.filename().string(), names);
}

// Makes the folder and sees to it that it holds no data set.
void prepare_folder(const std::filesystem::path& folder, bool force) {
  try {
    std::filesystem::create_directories(folder);
    std::vector<std::filesystem::path> old_files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (belongs_to_dataset(entry.path())) old_files.push_back(entry.path());
    }
    if (!old_files.empty() && !force) {
      throw InputError(fmt::format("{} holds a data set already ({}); choose another folder, or --force to replace it",
                                   folder.string(),
                                   std::min_element(old_files.begin(), old_files.end())->filename().string()));
    }
    for (const std::filesystem::path& file : old_files) std::filesystem::remove(file);
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(fmt::format("cannot write a data set to {}: {}", folder.string(), error.code().message()));
  }
}

// The numbers 0, 1, ... of all models in random order (Fisher-Yates); class c has those from c * models_per_class on.
std::vector<int> scattered_numbers(const GeneratorOptions& options) {
  std::vector<int> numbers(static_cast<std::size_t>(options.classes) *
                           static_cast<std::size_t>(options.models_per_class));
  std::iota(numbers.begin(), numbers.end(), 0);
  RandomNumbers random(options.seed, ~std::uint64_t{0});
  for (std::size_t i = numbers.size(); i > 1; --i) std::swap(numbers[i - 1], numbers[random.below(i)]);
  return numbers;
}

std::string segmentation_text(const Eigen::VectorXi& labels) {
  std::string text;
  for (const int label : labels) text += std::to_string(label) + '\n';
  return text;
}

class ProgressCounter {
 public:
  ProgressCounter(const GeneratorProgress& progress, std::size_t total)
      : progress_(progress), total_(static_cast<int>(total)) {}

  void count_one() {
    const std::scoped_lock lock(mutex_);
    ++done_;
    if (progress_) progress_(done_, total_);
  }

 private:
  const GeneratorProgress& progress_;
  std::mutex mutex_;
  int done_ = 0;
  int total_;
};

struct Models {
  std::vector<int> numbers;  // of all classes
  std::filesystem::path folder;
};

void write_class(std::size_t class_index, const Models& models, const GeneratorOptions& options,
                 ProgressCounter& counter) {
  const ArticulatedBody body = make_body(class_skeleton(class_index), options.faces);
  const std::string segmentation = segmentation_text(body.labels);
  const auto count = static_cast<std::size_t>(options.models_per_class);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t model) {
    const std::string name = fmt::format("T{}", models.numbers[class_index * count + model]);
    write_off(models.folder / (name + ".off"), draw_numbered_model(body, class_index, model, options.seed));
    write_file_atomically(models.folder / (name + ".seg"), segmentation);
    counter.count_one();
  });
}

void write_parts(const std::filesystem::path& folder, std::size_t classes) {
  nlohmann::ordered_json parts;
  for (std::size_t c = 0; c < classes; ++c) {
    const Skeleton skeleton = class_skeleton(c);
    for (const Limb& limb : skeleton.limbs) parts[skeleton.name].push_back(part_name(limb));
  }
  write_file_atomically(folder / "parts.json", parts.dump(2) + '\n');
}

Classification classification_of(const std::vector<int>& numbers, const GeneratorOptions& options) {
  Classification classification;
  auto number = numbers.begin();
  for (int c = 0; c < options.classes; ++c) {
    ModelClass model_class;
    model_class.name = class_skeleton(static_cast<std::size_t>(c)).name;
    for (int m = 0; m < options.models_per_class; ++m) model_class.models.push_back(std::to_string(*number++));
    classification.classes.push_back(std::move(model_class));
  }
  return classification;
}

}  // namespace

std::vector<std::string> generated_class_names() {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < class_count(); ++c) names.push_back(class_skeleton(c).name);
  return names;
}

void generate_dataset(const std::filesystem::path& folder, const GeneratorOptions& options,
                      const GeneratorProgress& progress) {
  check_options(options);
  prepare_folder(folder, options.force);
  const Models models{scattered_numbers(options), folder};
  const auto classes = static_cast<std::size_t>(options.classes);
  ProgressCounter counter(progress, models.numbers.size());
  tbb::parallel_for(std::size_t{0}, classes, [&](std::size_t c) { write_class(c, models, options, counter); });
  write_parts(folder, classes);
  write_classification(folder / "test.cla", classification_of(models.numbers, options));
}

}  // namespace shapegauge
