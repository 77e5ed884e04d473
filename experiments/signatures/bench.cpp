// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/bench.h"

#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/experiments/signatures/model_picture.h"

namespace shapegauge {

StoredField stored_field(const Field& field, FieldValues computed, const Samples& samples) {
  const ScalarField values{.values = std::move(computed.values), .weights = samples.weights};
  const std::optional<Interval> range = value_range(values);
  if (!range) {
    throw InputError(fmt::format("the field {} has no value at any sample", to_json(field.settings).dump()));
  }
  return {.range = *range,
          .outcomes = std::move(computed.outcomes),
          .offset = computed.offset,
          .seconds = computed.build_seconds + computed.query_seconds,
          .values = values.values};
}

FeatureDescription describe_features(const DescriptorChoice& choice, const DescriptorInput& input,
                                     const LearntFeatures& learnt) {
  const Stopwatch stopwatch;
  Eigen::VectorXf features = compute_features(choice.descriptor, input, learnt, choice.values);
  return {.features = std::move(features), .seconds = stopwatch.seconds()};
}

CachedShape::CachedShape(std::string key, std::function<PerturbedShape()> read, const PreparationOptions& preparation,
                         bool parallel, Cache& cache)
    : key_(std::move(key)),
      read_(std::move(read)),
      preparation_(preparation),
      parallel_(parallel),
      cache_(&cache),
      facts_(cache.find<ShapeFacts>(EntryKind::shape, key_)) {}

CachedShape::Opened& CachedShape::opened() {
  if (opened_) return *opened_;
  PerturbedShape perturbed = read_();
  ShapeFacts facts;
  facts.diagnostics = facts_ ? facts_->diagnostics : diagnose(perturbed.shape);
  facts.chosen = std::move(perturbed.chosen);
  facts.remarks = std::move(perturbed.remarks);
  auto opened = std::make_unique<Opened>();
  opened->prepared = prepare_shape(std::move(perturbed.shape), preparation_);
  const PreparedShape& prepared = opened->prepared;
  facts.area = prepared.area;
  facts.noise = prepared.noise.relative();
  facts.pass_band = prepared.pass_band;
  // Smoothing changes the diagnostics.
  opened->source.emplace(prepared.shape, prepared.pass_band > 0 ? std::nullopt : std::optional(facts.diagnostics));
  opened_ = std::move(opened);
  if (!facts_) {
    cache_->put(EntryKind::shape, key_, facts);
    facts_ = std::move(facts);
  }
  return *opened_;
}

const ShapeFacts& CachedShape::facts() {
  if (!facts_) opened();
  return facts_.value();
}

const PreparedShape& CachedShape::prepared() { return opened().prepared; }

const Samples& CachedShape::samples(SamplePlan plan) {
  Opened& open = opened();
  // A cloud is sampled at its points for either site.
  if (is_cloud(open.prepared.shape) && plan.site == SampleSite::faces) plan.site = SampleSite::vertices;
  const auto [entry, is_new] = open.samples.try_emplace(plan);
  if (is_new) entry->second = take_samples(open.prepared.shape, plan);
  return entry->second;
}

FieldValues CachedShape::compute(const Field& field) {
  const Samples& sites = samples(field.settings.samples);
  return field.compute(*opened().source, sites, parallel_);
}

const StoredField& CachedShape::field(const Field& field) {
  const std::string key = field_key(key_, field);
  const auto known = fields_.find(key);
  if (known != fields_.end()) return known->second;
  StoredField found = cache_->get(EntryKind::field, key,
                                  [&] { return stored_field(field, compute(field), samples(field.settings.samples)); });
  return fields_.emplace(key, std::move(found)).first->second;
}

const Eigen::VectorXd& CachedShape::weights(const SamplePlan& plan) {
  const auto known = weights_.find(plan);
  if (known != weights_.end()) return known->second;
  Eigen::VectorXd found =
      cache_->get(EntryKind::samples, samples_key(key_, plan), [&] { return samples(plan).weights; });
  return weights_.emplace(plan, std::move(found)).first->second;
}

ScalarField CachedShape::values(const Field& what) {
  return {.values = field(what).values, .weights = weights(what.settings.samples)};
}

FeatureDescription CachedShape::features(const DescriptorChoice& choice) {
  std::vector<std::string> keys;
  for (const Field& field : choice.fields) keys.push_back(field_key(key_, field));
  return cache_->get(EntryKind::features, features_key(key_, choice, keys, ""), [&] {
    std::vector<ScalarField> fields;
    for (const Field& field : choice.fields) fields.push_back(values(field));
    FieldSource& source = *opened().source;
    return describe_features(choice, {.shape = source.shape(), .fields = fields, .proxy = &source.proxy()}, {});
  });
}

std::string CachedShape::picture(const Field& what, const PictureOptions& options, const Eigen::Vector3d& up) {
  return cache_->get(EntryKind::picture, picture_key(field_key(key_, what), options, up), [&] {
    const Shape& shape = prepared().shape;
    return model_picture(shape, take_samples(shape, what.settings.samples), field(what).values, options, up);
  });
}

std::string CachedShape::view(std::span<const Field> fields, const std::vector<bool>& has_field,
                              const ShapeDrawing& drawing) {
  std::vector<std::string> keys;
  for (const Field& field : fields) keys.push_back(field_key(key_, field));
  return cache_->get(EntryKind::view, view_key(keys, drawing), [&] {
    const Shape& shape = prepared().shape;
    std::map<SamplePlan, Samples> samples;
    std::vector<Eigen::VectorXd> values;
    std::vector<SampledField> viewed;
    values.reserve(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const SamplePlan& plan = fields[i].settings.samples;
      if (!samples.contains(plan)) samples.emplace(plan, take_samples(shape, plan));
      const Samples& sites = samples.at(plan);
      values.push_back(has_field[i] ? field(fields[i]).values
                                    : Eigen::VectorXd(Eigen::VectorXd::Constant(
                                          sites.points.rows(), std::numeric_limits<double>::quiet_NaN())));
      viewed.push_back({.samples = sites, .values = values.back()});
    }
    return model_view(shape, viewed, drawing);
  });
}

}  // namespace shapegauge
