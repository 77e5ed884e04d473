#include "shapegauge/experiments/signatures/describe_learnt.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "shapegauge/experiments/signatures/cache_records.h"

namespace shapegauge {

namespace {

/// Input for learning from one model: its fields, and their keys in the cache.
struct Lesson {
  std::vector<ScalarField> fields;
  std::vector<std::string> keys;
};

/// By the model's index in the data set.
using Lessons = std::map<std::size_t, Lesson>;

/// Learnt features with their key.
struct Learnt {
  std::string key;
  LearntFeatures features;
};

Lessons lessons_of(const DescribedModels& models, const PlannedDescriptor& planned, const DescriptorChoice& choice) {
  Lessons lessons;
  for (const auto& [index, model] : models) {
    const auto is_missing = [&fields = model.fields](std::size_t field) { return !fields[field].error.empty(); };
    if (std::ranges::any_of(planned.fields, is_missing)) continue;
    Lesson& lesson = lessons[index];
    for (std::size_t k = 0; k < planned.fields.size(); ++k) {
      lesson.fields.push_back(kept_field(model.fields[planned.fields[k]]));
      lesson.keys.push_back(field_key(model.shape_key, choice.fields[k]));
    }
  }
  return lessons;
}

/// Serialises fields in single precision, in which they are stored.
std::string bytes_of_lessons(const Lessons& lessons) {
  Packer packer;
  for (const auto& [index, lesson] : lessons) {
    packer.add(index).add(lesson.fields.size());
    for (std::size_t k = 0; k < lesson.fields.size(); ++k) {
      packer.add(Eigen::VectorXf(lesson.fields[k].values.cast<float>()));
      packer.add(Eigen::VectorXf(lesson.fields[k].weights.cast<float>())).add(lesson.keys[k]);
    }
  }
  return std::move(packer).bytes();
}

void unpack(std::string_view bytes, Lessons& lessons) {
  for (Unpacker unpacker(bytes); !unpacker.is_at_end();) {
    Lesson& lesson = lessons[unpacker.take_value<std::size_t>()];
    const auto count = unpacker.take_value<std::size_t>();
    for (std::size_t k = 0; k < count; ++k) {
      const auto values = unpacker.take_value<Eigen::VectorXf>();
      const auto weights = unpacker.take_value<Eigen::VectorXf>();
      lesson.fields.push_back({.values = values.cast<double>(), .weights = weights.cast<double>()});
      lesson.keys.push_back(unpacker.take_value<std::string>());
    }
  }
}

/// Meshes are not available.
DescriptorInput input_of(const Lesson& lesson) {
  static const Shape none;
  return {.shape = none, .fields = lesson.fields};
}

/// Learns from all models.
Learnt learn(const Lessons& lessons, const DescriptorChoice& choice, Cache& cache) {
  std::vector<std::vector<std::string>> keys;
  for (const auto& [index, lesson] : lessons) keys.push_back(lesson.keys);
  Learnt learnt{.key = learnt_key(choice, keys), .features = {}};
  auto cached = cache.lookup(EntryKind::learnt, learnt.key, read_learnt);
  const bool found = cached && cached->size() > 0;
  cache.count(EntryKind::learnt, found);
  if (found) {
    learnt.features = std::move(*cached);
    return learnt;
  }
  std::vector<DescriptorInput> inputs;
  for (const auto& [index, lesson] : lessons) inputs.push_back(input_of(lesson));
  learnt.features = choice.descriptor.learn(inputs, choice.values);
  cache.store(EntryKind::learnt, learnt.key, learnt_record(learnt.features));
  return learnt;
}

/// Maximum size of the fields that rank 0 receives from all others for learning.
constexpr std::size_t most_bytes_to_learn_from = std::size_t{2} << 30;

/// Learns on rank 0 from the models of all ranks.
Learnt learn_together(const Lessons& own, const std::string& name, const DescriptorChoice& choice, Cache& cache,
                      Communicator& ranks) {
  if (ranks.size() == 1) return learn(own, choice, cache);
  std::string bytes = bytes_of_lessons(own);
  std::size_t all = 0;
  for (const std::string& count : ranks.gather(std::move(Packer().add(bytes.size())).bytes())) {
    all += Unpacker(count).take_value<std::size_t>();
  }
  if (ranks.rank() == 0 && all <= most_bytes_to_learn_from) all = 0;
  agree_on(ranks.rank() == 0 && all > 0
               ? fmt::format("the signature \"{}\" learns from the fields of all models, whose {:.1f} GB exceed the "
                             "limit with several processes; run in one process, or without that signature",
                             name, static_cast<double>(all) / 1e9)
               : "",
           ranks);
  const std::vector<std::string> parts = ranks.gather(std::move(bytes));
  const std::string told = on_first_rank(ranks, [&] {
    Lessons lessons;
    for (const std::string& part : parts) unpack(part, lessons);
    const Learnt learnt = learn(lessons, choice, cache);
    return std::move(Packer().add(learnt.key).add(learnt.features)).bytes();
  });
  Learnt learnt;
  Unpacker(told).take(learnt.key).take(learnt.features);
  return learnt;
}

FeatureDescription describe(const Lesson& lesson, const std::string& shape_key, const DescriptorChoice& choice,
                            const Learnt& learnt, Cache& cache) {
  const std::string key = features_key(shape_key, choice, lesson.keys, learnt.key);
  auto cached = cache.lookup(EntryKind::features, key, read_features);
  cache.count(EntryKind::features, cached.has_value());
  if (cached) return std::move(*cached);
  FeatureDescription features = describe_features(choice, input_of(lesson), learnt.features);
  cache.store(EntryKind::features, key, features_record(features));
  return features;
}

}  // namespace

std::vector<ModelFailure> describe_learnt(DescribedModels& models, const Configuration& configuration,
                                          std::span<const PlannedField> plan, const RunContext& context,
                                          std::vector<LearntFeatures>& learnt_features) {
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(configuration.signatures, plan);
  learnt_features.assign(descriptors.size(), {});
  const bool stops = configuration.on_error == OnError::stop;
  for (std::size_t d = 0; d < descriptors.size(); ++d) {
    if (!descriptors[d].learns) continue;
    const SignatureConfiguration& signature = configuration.signatures[descriptors[d].signature];
    const DescriptorChoice& choice = *signature.descriptor;
    Lessons lessons = lessons_of(models, descriptors[d], choice);
    for (;;) {
      if (context.control.interrupted()) throw Interrupted();
      const Learnt learnt = learn_together(lessons, signature.name, choice, context.cache, context.ranks);
      std::vector<std::size_t> own;
      for (const auto& [index, lesson] : lessons) own.push_back(index);
      const auto job = [&](std::size_t i) {
        ModelDescription& model = models.at(i);
        model.features[d] = describe(lessons.at(i), model.shape_key, choice, learnt, context.cache);
      };
      std::vector<ModelFailure> failures =
          failures_of_all(for_each_model(own, signature.name, stops, context.control, job), context.ranks);
      learnt_features[d] = learnt.features;
      if (stops && !failures.empty()) return failures;
      if (failures.empty()) break;
      // They affect what is learnt: once more without them.
      for (const ModelFailure& failure : failures) {
        if (lessons.erase(failure.model) > 0) models.at(failure.model).features[d] = {{}, 0, failure.message};
      }
    }
  }
  return {};
}

}  // namespace shapegauge
