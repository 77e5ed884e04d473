#include "shapegauge/experiments/signatures/describe_through_cache.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/signatures/cache_records.h"
#include "shapegauge/experiments/signatures/model_picture.h"
#include "shapegauge/experiments/signatures/model_view.h"

namespace shapegauge {

namespace {

/// Description of a model, assembled from the cache and computed parts.
class DescribedModel {
 public:
  /// `view_faces` is that of its view; 0 for no view.
  DescribedModel(const Configuration& configuration, std::span<const PlannedField> plan, std::string shape_key,
                 Eigen::Index view_faces, Cache& cache)
      : configuration_(&configuration), shape_key_(std::move(shape_key)), cache_(&cache), view_faces_(view_faces) {
    histograms_.resize(configuration.signatures.size());
    for (const PlannedField& field : plan) {
      fields_.push_back({.rest = field, .key = field_key(shape_key_, field.field), .found = {}});
      if (!is_pictured(field, configuration)) continue;
      pictured_ = fields_.size() - 1;
      picture_key_ = picture_key(fields_.back().key, configuration.report.picture_options);
    }
    if (view_faces > 0) viewed_ = viewed_fields(plan, configuration);
    std::vector<std::string> viewed_keys;
    for (const std::size_t field : viewed_) viewed_keys.push_back(fields_[field].key);
    view_key_ = view_key(viewed_keys, view_faces);
    for (PlannedDescriptor& descriptor : plan_descriptors(configuration.signatures, plan)) {
      std::vector<std::string> keys;
      for (const std::size_t field : descriptor.fields) keys.push_back(fields_[field].key);
      const DescriptorChoice& choice = *configuration.signatures[descriptor.signature].descriptor;
      descriptors_.push_back({.plan = std::move(descriptor),
                              .choice = &choice,
                              .key = features_key(shape_key_, choice, keys, ""),
                              .found = {}});
    }
  }

  /// Looks up the cached parts.
  void lookup() {
    shape_ = cache_->lookup(EntryKind::shape, shape_key_, read_shape_record);
    cache_->count(EntryKind::shape, shape_.has_value());
    if (pictured_) {
      picture_ = cache_->lookup(EntryKind::picture, picture_key_, read_picture);
      cache_->count(EntryKind::picture, picture_.has_value());
    }
    if (!viewed_.empty()) {
      view_ = cache_->lookup(EntryKind::view, view_key_, read_view);
      cache_->count(EntryKind::view, view_.has_value());
    }
    for (PartlyKnownFeatures& descriptor : descriptors_) {
      if (descriptor.plan.learns) {
        descriptor.found = FeatureDescription{};  // completed after all shapes
        continue;
      }
      descriptor.found = cache_->lookup(EntryKind::features, descriptor.key, read_features);
      cache_->count(EntryKind::features, descriptor.found.has_value());
      if (descriptor.found) continue;
      for (const std::size_t field : descriptor.plan.fields) fields_[field].described = true;
    }
    for (PartlyKnownField& field : fields_) lookup_field(field);
  }

  /// Returns the diagnostics if lookup() found them, otherwise null.
  [[nodiscard]] const ShapeDiagnostics* known_diagnostics() const { return shape_ ? &shape_->diagnostics : nullptr; }

  /// Returns the fields that lookup() did not find, in the order of the plan.
  [[nodiscard]] std::vector<PlannedField> missing() const {
    std::vector<PlannedField> missing;
    for (const PartlyKnownField& field : fields_) {
      if (!field.found) missing.push_back(field.rest);
    }
    return missing;
  }

  [[nodiscard]] bool is_complete() const {
    return shape_ && missing().empty() &&
           std::ranges::all_of(descriptors_, [](const PartlyKnownFeatures& one) { return one.found.has_value(); });
  }

  /// Receives the values of the missing field of that index: stores them, and keeps those needed by other parts.
  void take_values(std::size_t index, const Samples& samples, const FieldValues& computed) {
    PartlyKnownField& field = *missing_fields().at(index);
    if (field.described) field.values = {.values = computed.values, .weights = samples.weights};
    if (draws(field)) field.drawn = computed.values;
    store_values(index, samples, computed);
  }

  /// Computes the missing features after all fields.
  void describe(FieldSource& source) {
    for (PartlyKnownFeatures& descriptor : descriptors_) {
      if (descriptor.found) continue;
      descriptor.found = features_of(descriptor, source);
      if (descriptor.found->error.empty()) {
        cache_->store(EntryKind::features, descriptor.key, features_record(*descriptor.found));
      }
    }
  }

  [[nodiscard]] bool is_drawing_missing() const { return is_picture_missing() || is_view_missing(); }

  /// Renders missing pictures and views after all fields.
  void draw(const Shape& shape) {
    if (is_picture_missing() && fields_[*pictured_].drawn.size() > 0) {
      const PartlyKnownField& field = fields_[*pictured_];
      picture_ = model_picture(shape, take_samples(shape, field.rest.field.settings.samples), field.drawn,
                               configuration_->report.picture_options);
      cache_->store(EntryKind::picture, picture_key_, picture_record(*picture_));
    }
    if (!is_view_missing()) return;
    std::map<SamplePlan, Samples> samples;
    std::vector<SampledField> fields;
    for (const std::size_t i : viewed_) {
      const SamplePlan& plan = fields_[i].rest.field.settings.samples;
      if (!samples.contains(plan)) samples.emplace(plan, take_samples(shape, plan));
      const Samples& sites = samples.at(plan);
      Eigen::VectorXd& values = fields_[i].drawn;
      if (values.size() == 0) {  // the shape does not have the field
        values.setConstant(sites.points.rows(), std::numeric_limits<double>::quiet_NaN());
      }
      fields.push_back({.samples = sites, .values = values});
    }
    view_ = model_view(shape, fields, view_faces_);
    cache_->store(EntryKind::view, view_key_, view_record(*view_));
  }

  /// Adds and stores the computed missing fields.
  void complete(ModelDescription computed) {
    const std::vector<PartlyKnownField*> missing = missing_fields();
    for (std::size_t i = 0; i < missing.size(); ++i) {
      if (computed.fields[i].error.empty()) {
        cache_->count(EntryKind::field, false);
        store_histograms(*missing[i], computed.fields[i], computed.histograms);
      }
      missing[i]->found = std::move(computed.fields[i]);
    }
    if (shape_) return;
    cache_->store(EntryKind::shape, shape_key_, shape_record(computed));
    shape_ = std::move(computed);
  }

  /// Returns the complete description.
  ModelDescription description() && {
    ModelDescription description = std::move(shape_.value());
    description.histograms = std::move(histograms_);
    description.fields.clear();
    for (PartlyKnownField& field : fields_) description.fields.push_back(std::move(field.found.value()));
    description.features.clear();
    for (PartlyKnownFeatures& descriptor : descriptors_) {
      description.features.push_back(std::move(descriptor.found.value()));
    }
    description.shape_key = shape_key_;
    description.picture = std::move(picture_).value_or("");
    description.view = std::move(view_).value_or("");
    return description;
  }

 private:
  struct PartlyKnownField {
    PlannedField rest;  ///< with the signatures that are still to be computed
    std::string key;
    std::optional<FieldDescription> found;
    bool described = false;      ///< by descriptors whose features are missing
    ScalarField values = {};     ///< where it is
    Eigen::VectorXd drawn = {};  ///< the values, where draws()
  };

  struct PartlyKnownFeatures {
    PlannedDescriptor plan;
    const DescriptorChoice* choice;
    std::string key;
    std::optional<FeatureDescription> found;
  };

  /// Computes features from the fields.
  [[nodiscard]] FeatureDescription features_of(const PartlyKnownFeatures& descriptor, FieldSource& source) const {
    std::vector<ScalarField> fields;
    for (const std::size_t field : descriptor.plan.fields) {
      const std::string& error = fields_[field].found.value().error;
      if (!error.empty()) return {.features = {}, .seconds = 0, .error = error};
      fields.push_back(fields_[field].values);
    }
    try {
      return describe_features(*descriptor.choice,
                               {.shape = source.shape(), .fields = fields, .proxy = &source.proxy()}, {});
    } catch (const InputError& error) {
      if (configuration_->on_error == OnError::stop) throw;
      return {.features = {}, .seconds = 0, .error = error.what()};
    }
  }

  /// Stores the values of the missing field of that index.
  void store_values(std::size_t index, const Samples& samples, const FieldValues& computed) {
    const std::optional<Interval> range = value_range({.values = computed.values, .weights = samples.weights});
    if (cache_->folder().empty() || !range) return;  // without a value the model is a failure: nothing to store
    const PartlyKnownField& field = *missing_fields().at(index);
    FieldDescription facts;
    facts.range = *range;
    facts.outcomes = computed.outcomes;
    facts.offset = computed.offset;
    facts.seconds = computed.build_seconds + computed.query_seconds;
    const std::string weights = samples_key(shape_key_, field.rest.field.settings.samples);
    if (weights_stored_.insert(weights).second) {
      cache_->store(EntryKind::samples, weights, numbers_record(samples.weights));
    }
    cache_->store(EntryKind::field, field.key, field_record({.facts = std::move(facts), .values = computed.values}));
  }

  [[nodiscard]] const HistogramConfiguration& wanted(std::size_t signature) const {
    return configuration_->signatures[signature].histogram;
  }

  std::vector<PartlyKnownField*> missing_fields() {
    std::vector<PartlyKnownField*> missing;
    for (PartlyKnownField& field : fields_) {
      if (!field.found) missing.push_back(&field);
    }
    return missing;
  }

  [[nodiscard]] bool is_picture_missing() const { return pictured_ && !picture_; }
  [[nodiscard]] bool is_view_missing() const { return !viewed_.empty() && !view_; }

  /// Returns true if missing pictures or views need its values.
  [[nodiscard]] bool draws(const PartlyKnownField& field) const {
    const auto index = static_cast<std::size_t>(&field - fields_.data());
    return (is_picture_missing() && index == *pictured_) ||
           (is_view_missing() && std::ranges::find(viewed_, index) != viewed_.end());
  }

  void lookup_field(PartlyKnownField& field) {
    std::optional<FieldDescription> facts;
    std::erase_if(field.rest.signatures, [&](std::size_t signature) {
      if (wanted(signature).range == HistogramRange::dataset) return false;  // depends on the other shapes
      auto histogram =
          cache_->lookup(EntryKind::histogram, histogram_key(field.key, wanted(signature)), read_histogram_record);
      if (!histogram) return false;
      cache_->count(EntryKind::histogram, true);
      histograms_[signature] = std::move(histogram->bins);
      facts = std::move(histogram->facts);
      return true;
    });
    const bool values_wanted =
        field.rest.keep_values || field.described || !field.rest.signatures.empty() || draws(field) || !facts;
    field.found = values_wanted ? lookup_values(field) : std::move(facts);
    if (field.found) cache_->count(EntryKind::field, true);
  }

  /// Returns the facts of the field from cached values, with the missing histograms.
  std::optional<FieldDescription> lookup_values(PartlyKnownField& field) {
    const std::string samples = samples_key(shape_key_, field.rest.field.settings.samples);
    const auto weights = cache_->lookup(EntryKind::samples, samples, read_numbers);
    if (!weights) return std::nullopt;
    auto cached = cache_->lookup(EntryKind::field, field.key, read_field_record);
    if (!cached || cached->values.size() != weights->size()) return std::nullopt;
    if (draws(field)) field.drawn = cached->values;
    if (field.described) field.values = {.values = cached->values, .weights = *weights};
    std::vector<Eigen::VectorXf> histograms(histograms_.size());
    try {
      describe_field({.values = std::move(cached->values), .weights = *weights}, field.rest, configuration_->signatures,
                     cached->facts, histograms);
    } catch (const InputError&) {
      return std::nullopt;  // no histogram of these values: reported when the field is computed
    }
    store_histograms(field, cached->facts, histograms);
    return std::move(cached->facts);
  }

  /// Adds and stores the computed histograms of a field.
  void store_histograms(const PartlyKnownField& field, const FieldDescription& facts,
                        std::vector<Eigen::VectorXf>& histograms) {
    for (const std::size_t signature : field.rest.signatures) {
      if (wanted(signature).range == HistogramRange::dataset) continue;
      cache_->count(EntryKind::histogram, false);
      histograms_[signature] = std::move(histograms[signature]);
      FieldDescription without_values = facts;
      without_values.values.resize(0);
      without_values.weights.resize(0);
      cache_->store(EntryKind::histogram, histogram_key(field.key, wanted(signature)),
                    histogram_record({.facts = std::move(without_values), .bins = histograms_[signature]}));
    }
  }

  const Configuration* configuration_;
  std::string shape_key_;
  Cache* cache_;
  std::optional<ModelDescription> shape_;  ///< without fields and histograms
  std::vector<PartlyKnownField> fields_;
  std::vector<PartlyKnownFeatures> descriptors_;
  std::vector<Eigen::VectorXf> histograms_;  ///< by signature
  std::set<std::string> weights_stored_;     ///< by key
  std::optional<std::size_t> pictured_;      ///< the field that colours the picture, where one is wanted
  std::string picture_key_;
  std::optional<std::string> picture_;
  std::vector<std::size_t> viewed_;  ///< the fields of the view, where one is wanted
  Eigen::Index view_faces_;
  std::string view_key_;
  std::optional<std::string> view_;
};

}  // namespace

ModelDescription describe_through_cache(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                        std::span<const PlannedField> plan, bool parallel, Cache& cache) {
  const Model& source = dataset.models[model];
  const ShapeSource file = read_shape_source(source.file);
  const std::string hash = sha256_of_shape(file);
  const ModelSource depends_on{.sha256 = hash, .file = source.file, .id = source.id, .index = model};
  const bool viewed = configuration.report.views && dataset.models.size() <= most_models_with_views;
  DescribedModel described(
      configuration, plan,
      shape_key(depends_on, configuration.preparation, configuration.perturbations, configuration.seed),
      viewed ? faces_of_views(dataset.models.size()) : 0, cache);
  described.lookup();
  const auto perturbed = [&] {
    return perturb_model(read_shape(file), configuration.perturbations, configuration.seed, source.id, model);
  };
  if (!described.is_complete()) {
    PreparedModel prepared = prepare_model(perturbed(), configuration.preparation, described.known_diagnostics());
    FieldSource fields(prepared.prepared.shape, prepared.known_diagnostics());
    describe_fields(prepared, fields, configuration.signatures, described.missing(), parallel, configuration.on_error,
                    [&](std::size_t field, const PreparedShape&, const Samples& samples, const FieldValues& computed) {
                      described.take_values(field, samples, computed);
                    });
    described.complete(std::move(prepared.description));
    described.describe(fields);
    described.draw(prepared.prepared.shape);
  } else if (described.is_drawing_missing()) {
    described.draw(prepare_shape(perturbed().shape, configuration.preparation).shape);
  }
  ModelDescription description = std::move(described).description();
  description.sha256 = hash;
  return description;
}

}  // namespace shapegauge
