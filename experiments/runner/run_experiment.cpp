#include "shapegauge/experiments/runner/run_experiment.h"

#include <chrono>
#include <fmt/format.h>
#include <functional>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/datasets/layouts.h"
#include "shapegauge/experiments/runner/cache_records.h"
#include "shapegauge/experiments/runner/compute_signatures.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

/// What the folder's own record says of the data set in it; null where there is none.
Json record_in(const fs::path& file) {
  try {
    return fs::exists(file) ? read_json(file) : Json();
  } catch (const InputError&) {
    return {};
  }
}

void generate(const fs::path& folder, const GeneratorOptions& options, const RunControl& control) {
  const fs::path record_file = folder / "generated.json";
  Json record{{"generate", to_json(options)}, {"version", version()}, {"commit", commit()}, {"complete", true}};
  const Json earlier = record_in(record_file);
  if (earlier == record) return;

  // The record comes first, to know the folder for our own again after an interruption.
  fs::create_directories(folder);
  record["complete"] = false;
  GeneratorOptions now = options;
  now.force = earlier.is_object();
  if (now.force || fs::is_empty(folder)) write_file_atomically(record_file, record.dump(2) + "\n");
  generate_dataset(folder, now, [&](int done, int total) {
    if (control.interrupted()) throw Interrupted();
    control.progress("generating models", static_cast<std::size_t>(done), static_cast<std::size_t>(total));
  });
  record["complete"] = true;
  write_file_atomically(record_file, record.dump(2) + "\n");
}

constexpr Eigen::Index most_shapes_kept = 2900;

/// Seconds since the last call, or since the beginning.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::vector<int> labels_of(const std::vector<Model>& models) {
  std::vector<int> labels;
  labels.reserve(models.size());
  for (const Model& model : models) labels.push_back(model.label);
  return labels;
}

std::vector<Evaluation> evaluations_of(const MethodResults& method, const std::vector<Model>& models,
                                       const Configuration& configuration) {
  const std::vector<int> labels = labels_of(models);
  std::vector<Evaluation> evaluations;
  for (const Protocol protocol : configuration.protocols) {
    evaluations.push_back(evaluate(method.distances, labels,
                                   {.protocol = protocol,
                                    .ties = configuration.ties,
                                    .measures = configuration.measures,
                                    .minimum_class_size = configuration.minimum_class_size}));
  }
  return evaluations;
}

DistanceMatrix derived_distances(const SignatureConfiguration& signature,
                                 const std::vector<DistanceMatrix>& distances) {
  std::vector<DistanceMatrix> parts;
  for (const std::size_t part : signature.parts) parts.push_back(distances[part]);
  try {
    return signature.derived->compute(parts);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("signature \"{}\": {}", signature.name, error.what()));
  }
}

/// The distance matrices of the signatures of these features.
std::vector<DistanceMatrix> all_distances(const Configuration& configuration, const std::vector<Signatures>& features,
                                          const RunControl& control, Cache& cache) {
  std::vector<DistanceMatrix> distances(configuration.signatures.size());
  std::size_t done = 0;
  for (const std::size_t i : computation_order(configuration.signatures)) {
    if (control.interrupted()) throw Interrupted();
    control.progress("distances", done++, distances.size());
    const SignatureConfiguration& signature = configuration.signatures[i];
    if (signature.derived) {
      distances[i] = derived_distances(signature, distances);
    } else if (signature.descriptor) {
      distances[i] = distances_through_cache(features[i], signature.descriptor->descriptor, cache);
    } else {
      distances[i] = distances_through_cache(features[i], configuration.distance, cache);
    }
  }
  return distances;
}

void run_stages(const Configuration& configuration, const std::filesystem::path& generated_folder,
                const RunControl& control, Cache& cache, ExperimentResults& results) {
  Stopwatch stopwatch;
  const Dataset dataset = prepare_dataset(configuration, generated_folder, control);
  results.timings.emplace_back("dataset", stopwatch.lap());

  ComputedSignatures computed = compute_signatures(dataset, configuration, control, cache);
  results.classes = dataset.classes;
  for (const std::size_t model : computed.models) results.models.push_back(dataset.models[model]);
  for (const ModelFailure& failure : computed.failures) {
    results.failures.push_back({.model = dataset.models[failure.model], .message = failure.message});
  }
  results.fields = std::move(computed.fields);
  results.shapes = std::move(computed.shapes);
  results.pictures = std::move(computed.pictures);
  results.views = std::move(computed.views);
  results.viewed = std::move(computed.viewed);
  results.timings.emplace_back("signatures", stopwatch.lap());

  std::vector<DistanceMatrix> distances = all_distances(configuration, computed.signatures, control, cache);
  for (std::size_t i = 0; i < configuration.signatures.size(); ++i) {
    results.methods.push_back({.name = configuration.signatures[i].name,
                               .distances = std::move(distances[i]),
                               .evaluations = {},
                               .signatures = std::move(computed.signatures[i]),
                               .histogram_ranges = std::move(computed.histogram_ranges[i])});
  }
  results.timings.emplace_back("distances", stopwatch.lap());

  for (MethodResults& method : results.methods) {
    if (control.interrupted()) throw Interrupted();
    method.evaluations = evaluations_of(method, results.models, configuration);
  }
  results.timings.emplace_back("evaluation", stopwatch.lap());
}

}  // namespace

Dataset prepare_dataset(const Configuration& configuration, const fs::path& generated_folder,
                        const RunControl& control) {
  if (!configuration.generator) return find_dataset(configuration.location.value());
  generate(generated_folder, *configuration.generator, control);
  return find_dataset({.layout = "shrec11", .root = generated_folder, .classification = generated_folder / "test.cla"});
}

namespace {

/// The distances of the signatures by the distance of that name, which `compute` computes where the cache has none.
DistanceMatrix cached_distances(const Signatures& signatures, const std::string& distance, Cache& cache,
                                const std::function<DistanceMatrix()>& compute) {
  const bool kept = !cache.folder().empty() && signatures.rows() <= most_shapes_kept;
  const std::string key = kept ? distances_key(signatures, distance) : "";
  if (kept) {
    if (auto distances = cache.lookup(EntryKind::distances, key, read_distances)) {
      cache.count(EntryKind::distances, true);
      return std::move(*distances);
    }
  }
  DistanceMatrix distances = compute();
  cache.count(EntryKind::distances, false);
  if (kept) cache.store(EntryKind::distances, key, distances_record(distances));
  return distances;
}

}  // namespace

DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache) {
  return cached_distances(signatures, distance, cache, [&] { return distance_matrix(signatures, distance); });
}

DistanceMatrix distances_through_cache(const Signatures& features, const Descriptor& descriptor, Cache& cache) {
  return cached_distances(features, distance_of(descriptor), cache,
                          [&] { return descriptor_distances(descriptor, features); });
}

ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control, Cache& cache) {
  ExperimentResults results;
  results.configuration = configuration;
  results.threads = control.threads > 0 ? control.threads : available_threads();
  try {
    with_threads(results.threads, [&] { run_stages(configuration, generated_folder, control, cache, results); });
  } catch (const std::invalid_argument& error) {
    // What the modules below say of data that they cannot use: here the data come from the user.
    throw InputError(error.what());
  }
  results.cache = cache.report();
  return results;
}

ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control) {
  Cache none;
  return run_experiment(configuration, generated_folder, control, none);
}

}  // namespace shapegauge
