// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/generate_dataset.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/datasets/files/classification.h"
#include "shapegauge/datasets/generator/articulated_body.h"
#include "shapegauge/datasets/generator/class_skeletons.h"
#include "shapegauge/datasets/generator/mesh_solid.h"
#include "shapegauge/datasets/generator/object_classes.h"

namespace shapegauge {

namespace {

constexpr auto faces_option = option_of<&GeneratorOptions::faces>("faces", {.low = 1000, .high = 100'000},
                                                                  "Approximate number of triangles per model.");
constexpr auto seed_option = option_of<&GeneratorOptions::seed>("seed", seed_bounds, "Random seed of the shapes.");

constexpr int max_models = 1000;

/// A class of the generator.
struct GeneratedClass {
  std::string name;
  std::vector<std::string> parts;  ///< per label

  /// Makes a function that draws a model of about so many faces.
  std::function<std::function<SolidMesh(RandomNumbers&)>(int faces)> prepare;
};

/// Individuals of a skeleton in random poses.
GeneratedClass articulated_class(std::size_t index) {
  const Skeleton skeleton = class_skeleton(index);
  std::vector<std::string> parts;
  for (const Limb& limb : skeleton.limbs) parts.push_back(part_name(limb));
  return {skeleton.name, std::move(parts), [skeleton](int faces) {
            return [body = make_articulated_body(skeleton, faces)](RandomNumbers& random) {
              return SolidMesh{draw_model(body, random), body.labels};
            };
          }};
}

/// Rigid objects: drawn until one can be meshed.
GeneratedClass class_of_objects(const ObjectClass& objects) {
  return {objects.name, objects.parts, [&objects](int faces) {
            return [&objects, faces](RandomNumbers& random) {
              constexpr int attempts = 10;
              for (int attempt = 0; attempt < attempts; ++attempt) {
                if (std::optional<SolidMesh> mesh = mesh_solid(objects.draw(random), faces)) return *std::move(mesh);
              }
              throw std::runtime_error(fmt::format(
                  "no object of the generated class {} can be meshed; raise the number of faces", objects.name));
            };
          }};
}

/// All classes in their order: articulated bodies, then objects.
const std::vector<GeneratedClass>& generated_classes() {
  static const std::vector<GeneratedClass> classes = [] {
    std::vector<GeneratedClass> all;
    for (std::size_t c = 0; c < articulated_class_count(); ++c) all.push_back(articulated_class(c));
    for (const ObjectClass& objects : object_classes()) all.push_back(class_of_objects(objects));
    return all;
  }();
  return classes;
}

/// Returns the random stream of a model of a class.
RandomNumbers random_of(std::size_t class_index, std::size_t model, std::uint64_t seed) {
  return RandomNumbers(seed, (class_index << 32U) + model);
}

bool belongs_to_dataset(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (name == "test.cla" || name == "parts.json") return true;
  const std::string stem = file.stem().string();
  const bool numbered =
      stem.size() > 1 && stem[0] == 'T' && stem.find_first_not_of("0123456789", 1) == std::string::npos;
  return numbered && (file.extension() == ".off" || file.extension() == ".seg");
}

// Creates the folder and checks that it has no data set.
void prepare_folder(const std::filesystem::path& folder, bool replace) {
  try {
    std::filesystem::create_directories(folder);
    std::vector<std::filesystem::path> old_files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (belongs_to_dataset(entry.path())) old_files.push_back(entry.path());
    }
    if (!old_files.empty() && !replace) {
      throw InputError(
          fmt::format("{} already has a data set ({}); use another folder, or `replace=true` to replace it",
                      folder.string(), std::min_element(old_files.begin(), old_files.end())->filename().string()));
    }
    for (const std::filesystem::path& file : old_files) std::filesystem::remove(file);
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(fmt::format("cannot write a data set to {}: {}", folder.string(), error.code().message()));
  }
}

// Returns the numbers 0, 1, ... of all models in random order (Fisher-Yates); class c has those from c *
// models_per_class on.
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

struct Models {
  std::vector<int> numbers;  // of all classes
  std::filesystem::path folder;
};

void write_class(std::size_t class_index, const Models& models, const GeneratorOptions& options,
                 const std::function<void()>& count_one) {
  const auto draw = generated_classes()[class_index].prepare(options.faces);
  const auto count = static_cast<std::size_t>(options.models_per_class);
  parallel_for(std::size_t{0}, count, [&](std::size_t model) {
    const std::string name = fmt::format("T{}", models.numbers[class_index * count + model]);
    RandomNumbers random = random_of(class_index, model, options.seed);
    const SolidMesh made = draw(random);
    write_off(models.folder / (name + ".off"), made.mesh, fmt::format("{}{}", up_comment, word_of(UpAxis::z)));
    write_file_atomically(models.folder / (name + ".seg"), segmentation_text(made.labels));
    count_one();
  });
}

void write_parts(const std::filesystem::path& folder, std::size_t classes) {
  nlohmann::ordered_json parts;
  for (const GeneratedClass& one : std::span(generated_classes()).first(classes)) parts[one.name] = one.parts;
  write_file_atomically(folder / "parts.json", parts.dump(2) + '\n');
}

Classification classification_of(const std::vector<int>& numbers, const GeneratorOptions& options) {
  Classification classification;
  auto number = numbers.begin();
  for (int c = 0; c < options.classes; ++c) {
    ModelClass model_class;
    model_class.name = generated_classes()[static_cast<std::size_t>(c)].name;
    for (int m = 0; m < options.models_per_class; ++m) model_class.models.push_back(std::to_string(*number++));
    classification.classes.push_back(std::move(model_class));
  }
  return classification;
}

}  // namespace

const std::array<OptionParameter<GeneratorOptions>, 4>& generator_table() {
  static const std::array table{
      option_of<&GeneratorOptions::classes>(
          "classes", {.low = 1, .high = static_cast<double>(generated_classes().size())}, "Number of shape classes."),
      option_of<&GeneratorOptions::models_per_class>("models_per_class", {.low = 1, .high = max_models},
                                                     "Number of models per class."),
      faces_option, seed_option};
  return table;
}

std::span<const Parameter> generator_parameters() {
  static const auto parameters = parameters_of(generator_table());
  return parameters;
}

std::span<const Parameter> generated_model_parameters() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const GeneratedClass& one : generated_classes()) all.emplace_back(one.name);
    return all;
  }();
  static const std::vector<Parameter> parameters{{.name = "class",
                                                  .kind = ParameterKind::choice,
                                                  .choices = names,
                                                  .description = "Class of the generated shape."},
                                                 {.name = "model",
                                                  .kind = ParameterKind::integer,
                                                  .default_value = std::int64_t{0},
                                                  .bounds = {.low = 0, .high = max_models - 1},
                                                  .description = "Index of the generated model in its class, from 0."},
                                                 faces_option.parameter,
                                                 seed_option.parameter};
  return parameters;
}

Shape generate_model(const GeneratedModel& request) {
  const auto found = std::ranges::find(generated_classes(), request.model_class, &GeneratedClass::name);
  if (found == generated_classes().end()) {
    std::vector<std::string> names;
    for (const GeneratedClass& one : generated_classes()) names.push_back(one.name);
    throw InputError(unknown_word_message("generated class", request.model_class, names));
  }
  require_in_bounds("the number of the model", request.model, {.low = 0, .high = max_models - 1});
  require_in_bounds("the number of faces", request.faces, faces_option.parameter.bounds);
  const auto class_index = static_cast<std::size_t>(found - generated_classes().begin());
  RandomNumbers random = random_of(class_index, static_cast<std::size_t>(request.model), request.seed);
  return found->prepare(request.faces)(random).mesh;
}

void generate_dataset(const std::filesystem::path& folder, const GeneratorOptions& options,
                      const GeneratorProgress& progress) {
  check_options("generate", generator_table(), options);
  prepare_folder(folder, options.replace);
  const Models models{scattered_numbers(options), folder};
  const auto classes = static_cast<std::size_t>(options.classes);
  std::mutex mutex;
  int done = 0;
  const auto count_one = [&] {
    const std::scoped_lock lock(mutex);
    ++done;
    if (progress) progress(done, static_cast<int>(models.numbers.size()));
  };
  parallel_for(std::size_t{0}, classes, [&](std::size_t c) { write_class(c, models, options, count_one); });
  write_parts(folder, classes);
  write_classification(folder / "test.cla", classification_of(models.numbers, options));
}

}  // namespace shapegauge
