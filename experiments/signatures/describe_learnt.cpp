// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/describe_learnt.h"

#include <string>

#include "shapegauge/experiments/signatures/cache_keys.h"

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

Lessons lessons_of(const DescribedModels& models, std::span<const Field> fields, const DescriptorChoice& choice) {
  Lessons lessons;
  for (const auto& [index, model] : models) {
    if (!error_of_fields(model, fields, choice).empty()) continue;
    Lesson& lesson = lessons[index];
    for (const Field& field : choice.fields) {
      lesson.fields.push_back(to_scalar_field(model.fields[index_of(fields, field)]));
      lesson.keys.push_back(field_key(model.shape_key, field));
    }
  }
  return lessons;
}

/// Meshes are not available.
DescriptorInput input_of(const Lesson& lesson) {
  static const Shape none;
  return {.shape = none, .fields = lesson.fields};
}

/// Learns from all models through the cache.
Learnt learn(const Lessons& lessons, const DescriptorChoice& choice, Cache& cache) {
  std::vector<std::vector<std::string>> keys;
  for (const auto& [index, lesson] : lessons) keys.push_back(lesson.keys);
  Learnt learnt{.key = learnt_key(choice, keys), .features = {}};
  learnt.features = cache.get(EntryKind::learnt, learnt.key, [&] {
    std::vector<DescriptorInput> inputs;
    for (const auto& [index, lesson] : lessons) inputs.push_back(input_of(lesson));
    return choice.descriptor.learn(inputs, choice.values);
  });
  return learnt;
}

FeatureDescription describe(const Lesson& lesson, const std::string& shape_key, const DescriptorChoice& choice,
                            const Learnt& learnt, Cache& cache) {
  const std::string key = features_key(shape_key, choice, lesson.keys, learnt.key);
  return cache.get(EntryKind::features, key,
                   [&] { return describe_features(choice, input_of(lesson), learnt.features); });
}

}  // namespace

std::vector<ModelFailure> describe_learnt(DescribedModels& models, const Configuration& configuration,
                                          std::span<const Field> fields, const RunContext& context,
                                          std::vector<LearntFeatures>& learnt_features) {
  learnt_features.assign(configuration.signatures.size(), {});
  const bool stops = configuration.on_error == OnError::stop;
  for (std::size_t s = 0; s < configuration.signatures.size(); ++s) {
    const SignatureConfiguration& signature = configuration.signatures[s];
    if (!signature.descriptor || !needs_learning(*signature.descriptor)) continue;
    const DescriptorChoice& choice = *signature.descriptor;
    Lessons lessons = lessons_of(models, fields, choice);
    for (;;) {
      if (context.control.interrupted()) throw Interrupted();
      const Learnt learnt = learn(lessons, choice, context.cache);
      std::vector<std::size_t> indices;
      for (const auto& [index, lesson] : lessons) indices.push_back(index);
      const auto job = [&](std::size_t i) {
        ModelDescription& model = models.at(i);
        model.features[s] = describe(lessons.at(i), model.shape_key, choice, learnt, context.cache);
      };
      std::vector<ModelFailure> failures = for_each_model(indices, signature.name, stops, context.control, job);
      learnt_features[s] = learnt.features;
      if (stops && !failures.empty()) return failures;
      if (failures.empty()) break;
      // They affect what is learnt: once more without them.
      for (const ModelFailure& failure : failures) {
        lessons.erase(failure.model);
        models.at(failure.model).features[s] = {{}, 0, failure.message};
      }
    }
  }
  return {};
}

}  // namespace shapegauge
