#include "shapegauge/experiments/runner/describe_learnt.h"

#include <string>
#include <utility>

#include "shapegauge/experiments/runner/cache_records.h"

namespace shapegauge {

namespace {

/// A descriptor that learns, and all models that it learns from.
class Learner {
 public:
  Learner(const std::vector<std::optional<ModelDescription>>& models, const PlannedDescriptor& planned,
          const DescriptorChoice& choice, Cache& cache)
      : choice_(&choice), cache_(&cache) {
    fields_.resize(models.size());
    keys_.resize(models.size());
    for (std::size_t i = 0; i < models.size(); ++i) {
      if (!models[i]) continue;
      taking_part_.push_back(i);
      for (std::size_t k = 0; k < planned.fields.size(); ++k) {
        fields_[i].push_back(kept_field(models[i]->fields[planned.fields[k]]));
        keys_[i].push_back(field_key(models[i]->shape_key, choice.fields[k]));
      }
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& taking_part() const { return taking_part_; }

  void learn() {
    std::vector<std::vector<std::string>> keys;
    for (const std::size_t i : taking_part_) keys.push_back(keys_[i]);
    key_ = learnt_key(*choice_, keys);
    auto cached = cache_->lookup(EntryKind::learnt, key_, read_learnt);
    const bool found = cached && cached->size() > 0;
    cache_->count(EntryKind::learnt, found);
    if (found) {
      learnt_ = std::move(*cached);
      return;
    }
    std::vector<DescriptorInput> inputs;
    for (const std::size_t i : taking_part_) inputs.push_back(input(i));
    learnt_ = choice_->descriptor.learn(inputs, choice_->values);
    cache_->store(EntryKind::learnt, key_, learnt_record(learnt_));
  }

  FeatureDescription describe(std::size_t model, const std::string& shape_key) const {
    const std::string key = features_key(shape_key, *choice_, keys_[model], key_);
    auto cached = cache_->lookup(EntryKind::features, key, read_features);
    cache_->count(EntryKind::features, cached.has_value());
    if (cached) return std::move(*cached);
    FeatureDescription features = describe_features(*choice_, input(model), learnt_);
    cache_->store(EntryKind::features, key, features_record(features));
    return features;
  }

 private:
  [[nodiscard]] DescriptorInput input(std::size_t model) const { return {.shape = none_, .fields = fields_[model]}; }

  const DescriptorChoice* choice_;
  Cache* cache_;
  Shape none_;                                    ///< meshes are not kept
  std::vector<std::vector<ScalarField>> fields_;  ///< by model
  std::vector<std::vector<std::string>> keys_;    ///< of the fields, by model
  std::vector<std::size_t> taking_part_;
  std::string key_;
  LearntFeatures learnt_;
};

}  // namespace

std::vector<ModelFailure> describe_learnt(std::vector<std::optional<ModelDescription>>& models,
                                          const Configuration& configuration, std::span<const PlannedField> plan,
                                          const RunControl& control, Cache& cache) {
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(configuration.signatures, plan);
  for (std::size_t d = 0; d < descriptors.size(); ++d) {
    if (!descriptors[d].learns) continue;
    if (control.interrupted()) throw Interrupted();
    const SignatureConfiguration& signature = configuration.signatures[descriptors[d].signature];
    Learner learner(models, descriptors[d], *signature.descriptor, cache);
    learner.learn();
    std::vector<ModelFailure> failures =
        for_each_model(learner.taking_part(), signature.name, configuration.on_error == OnError::stop, control,
                       [&](std::size_t i) { models[i]->features[d] = learner.describe(i, models[i]->shape_key); });
    if (!failures.empty()) return failures;
  }
  return {};
}

}  // namespace shapegauge
