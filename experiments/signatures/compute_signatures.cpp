#include "shapegauge/experiments/signatures/compute_signatures.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <mutex>
#include <tbb/task_arena.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/cache_records.h"
#include "shapegauge/experiments/signatures/describe_learnt.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/describe_through_cache.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

/// Returns the ranges of a field on the models that have values of it.
std::vector<Interval> ranges_of(const std::vector<const ModelDescription*>& models, std::size_t field) {
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) {
    if (model->fields[field].error.empty()) ranges.push_back(model->fields[field].range);
  }
  return ranges;
}

/// Returns the union of the ranges of a field over all models.
Interval common_range(const std::vector<const ModelDescription*>& models, std::size_t field) {
  return enclosing_interval(ranges_of(models, field));
}

/// Returns one histogram signature of models that have it.
Signatures histograms_of(const std::vector<const ModelDescription*>& models, const HistogramConfiguration& wanted,
                         std::size_t signature, std::size_t field, std::span<const Interval> data_set_ranges) {
  Signatures table(static_cast<Eigen::Index>(models.size()), wanted.options.bins);
  const bool of_dataset = wanted.range == HistogramRange::dataset;
  parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    table.row(static_cast<Eigen::Index>(i)) =
        of_dataset ? kept_histogram(models[i]->fields[field], data_set_ranges[field], wanted.options)
                   : models[i]->histograms[signature];
  });
  return table;
}

/// Results for each model: the descriptions on this process, and the failures of all.
struct Described {
  DescribedModels models;
  std::vector<ModelFailure> failures;
  std::vector<LearntFeatures> learnt;              ///< by planned descriptor
  std::vector<std::vector<ModelFailure>> without;  ///< by signature: the models without it
};

[[noreturn]] void stop_for(const Dataset& dataset, const std::vector<ModelFailure>& failures, OnError on_error) {
  const ModelFailure& first = failures.front();
  const std::string& id = dataset.models[first.model].id;
  // All processes know the failures.
  if (on_error == OnError::skip) {
    throw SharedError(
        fmt::format("none of {} models can be used; the first is {}: {}", failures.size(), id, first.message));
  }
  const std::string others = failures.size() > 1 ? fmt::format(" (and {} more like it)", failures.size() - 1) : "";
  throw SharedError(
      fmt::format(R"(model {}: {}{}; repair or remove it, or set "on_error" to "skip")", id, first.message, others));
}

void stop_if_told(const Dataset& dataset, const std::vector<ModelFailure>& failures, OnError on_error) {
  const bool none_left = failures.size() == dataset.models.size();
  if (!failures.empty() && (none_left || on_error == OnError::stop)) {
    stop_for(dataset, failures, on_error);
  }
}

/// Returns the models that are not among the failures.
std::vector<std::size_t> models_without(const std::vector<ModelFailure>& failures, std::size_t count) {
  std::vector<std::size_t> models;
  auto failure = failures.begin();
  for (std::size_t i = 0; i < count; ++i) {
    if (failure != failures.end() && failure->model == i) {
      ++failure;
    } else {
      models.push_back(i);
    }
  }
  return models;
}

/// Returns the models without any signature.
std::vector<ModelFailure> without_signatures(const DescribedModels& models,
                                             const std::vector<SignatureConfiguration>& signatures,
                                             std::span<const PlannedField> plan) {
  std::vector<ModelFailure> failures;
  for (const auto& [index, model] : models) {
    const std::vector<std::string> errors = signature_errors(model, signatures, plan);
    if (std::ranges::none_of(errors, &std::string::empty)) failures.push_back({index, errors.front()});
  }
  return failures;
}

/// Finds the models of all ranks without each signature; throws if none has one of them. Collective.
void check_signatures_exist(const Dataset& dataset, const std::vector<SignatureConfiguration>& signatures,
                            Described& described, std::span<const PlannedField> plan, Communicator& ranks) {
  std::vector<std::vector<ModelFailure>> without(signatures.size());
  for (const auto& [index, model] : described.models) {
    std::vector<std::string> errors = signature_errors(model, signatures, plan);
    for (std::size_t i = 0; i < signatures.size(); ++i) {
      if (!errors[i].empty()) without[i].push_back({index, std::move(errors[i])});
    }
  }
  described.without.clear();
  const std::size_t models = dataset.models.size() - described.failures.size();
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    described.without.push_back(failures_of_all(without[i], ranks));
    const std::vector<ModelFailure>& all = described.without.back();
    if (all.size() < models) continue;
    throw SharedError(fmt::format("signature \"{}\": none of {} models can be used; the first is {}: {}",
                                  signatures[i].name, models, dataset.models[all.front().model].id,
                                  all.front().message));
  }
}

Described describe_models(const Dataset& dataset, const Configuration& configuration, const RunControl& control,
                          std::span<const PlannedField> plan, Cache& cache, Communicator& ranks) {
  Described described;
  described.failures = failures_of_all(ranks.rank() == 0 ? check_models(dataset) : std::vector<ModelFailure>(), ranks);
  stop_if_told(dataset, described.failures, configuration.on_error);
  const std::vector<std::size_t> remaining = models_without(described.failures, dataset.models.size());
  // Processing shapes in parallel needs no synchronisation, but a few shapes do not occupy all threads.
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency() * ranks.size());
  const bool parallel_within = remaining.size() < 2 * threads;
  const bool stops = configuration.on_error == OnError::stop;
  std::mutex mutex;
  const std::vector<ModelFailure> failures =
      for_each_model(remaining, "signatures", stops, control, ranks, [&](std::size_t model) {
        ModelDescription description =
            describe_through_cache(dataset, model, configuration, plan, parallel_within, cache);
        const std::scoped_lock lock(mutex);
        described.models.emplace(model, std::move(description));
      });
  const auto add = [&](std::vector<ModelFailure> more) {
    if (stops && more.size() > 1) more.resize(1);
    described.failures.insert(described.failures.end(), more.begin(), more.end());
    std::ranges::sort(described.failures, {}, &ModelFailure::model);
    stop_if_told(dataset, described.failures, configuration.on_error);
  };
  add(failures_of_all(failures, ranks));
  check_signatures_exist(dataset, configuration.signatures, described, plan, ranks);
  add(describe_learnt(described.models, configuration, plan, control, cache, ranks, described.learnt));
  const std::vector<ModelFailure> useless = without_signatures(described.models, configuration.signatures, plan);
  for (const ModelFailure& failure : useless) described.models.erase(failure.model);
  add(failures_of_all(useless, ranks));
  check_signatures_exist(dataset, configuration.signatures, described, plan, ranks);
  return described;
}

ArgumentError different_lengths(Eigen::Index one, Eigen::Index other) {
  return ArgumentError(fmt::format("a descriptor returned {} features for one model and {} for another", one, other));
}

/// Returns the features of one descriptor of models that have them.
Signatures features_of(const std::vector<const ModelDescription*>& models, std::size_t descriptor) {
  const Eigen::Index length = models.front()->features[descriptor].features.size();
  Signatures table(std::ssize(models), length);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Eigen::VectorXf& features = models[i]->features[descriptor].features;
    if (features.size() != length) {
      throw different_lengths(length, features.size());
    }
    table.row(static_cast<Eigen::Index>(i)) = features.transpose();
  }
  return table;
}

/// Returns a table with the rows of `some` at these places and NaN elsewhere; without columns if there are none.
Signatures rows_at_places(const Signatures& some, std::span<const Eigen::Index> places, std::size_t all) {
  const auto rows = static_cast<Eigen::Index>(all);
  if (some.rows() == rows) return some;
  Signatures table =
      Signatures::Constant(rows, places.empty() ? 0 : some.cols(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < places.size(); ++i) table.row(places[i]) = some.row(static_cast<Eigen::Index>(i));
  return table;
}

/// Positions of the models with each signature.
std::vector<std::vector<Eigen::Index>> places_with(const std::vector<const ModelDescription*>& models,
                                                   const std::vector<SignatureConfiguration>& signatures,
                                                   std::span<const PlannedField> plan) {
  std::vector<std::vector<Eigen::Index>> places(signatures.size());
  for (std::size_t model = 0; model < models.size(); ++model) {
    const std::vector<std::string> errors = signature_errors(*models[model], signatures, plan);
    for (std::size_t i = 0; i < signatures.size(); ++i) {
      if (errors[i].empty()) places[i].push_back(static_cast<Eigen::Index>(model));
    }
  }
  return places;
}

}  // namespace

NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration) {
  if (!signature.descriptor) return distances().at(configuration.distance);
  return {.name = distance_of(signature.descriptor->descriptor), .function = signature.descriptor->descriptor.distance};
}

std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields) {
  std::vector<Interval> ranges;
  for (std::size_t field = 0; field < fields; ++field) ranges.push_back(common_range(models, field));
  return ranges;
}

std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges) {
  std::vector<Signatures> tables(signatures.size());
  if (models.empty()) return tables;
  const std::vector<std::vector<Eigen::Index>> places = places_with(models, signatures, plan);
  const auto set_table = [&](std::size_t i, const auto& table_of) {
    std::vector<const ModelDescription*> with;
    for (const Eigen::Index place : places[i]) with.push_back(models[static_cast<std::size_t>(place)]);
    tables[i] = rows_at_places(with.empty() ? Signatures() : table_of(with), places[i], models.size());
  };
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      set_table(
          i, [&](const auto& with) { return histograms_of(with, signatures[i].histogram, i, field, data_set_ranges); });
    }
  }
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(signatures, plan);
  for (std::size_t d = 0; d < descriptors.size(); ++d) {
    set_table(descriptors[d].signature, [&](const auto& with) { return features_of(with, d); });
  }
  for (const std::size_t i : computation_order(signatures)) {
    if (signatures[i].field || signatures[i].descriptor || signatures[i].derived) continue;
    set_table(i, [&](const auto&) {
      std::vector<Signatures> parts;
      for (const std::size_t part : signatures[i].parts) parts.push_back(tables[part](places[i], Eigen::all));
      return concatenate(parts);
    });
  }
  return tables;
}

bool leaks(const ShapeDiagnostics& model, std::optional<double> chosen_offset, const nlohmann::json& settings) {
  const auto given = settings.find("offset");
  if (given == settings.end()) return false;
  return model.gap_size > (chosen_offset ? *chosen_offset : given->get<double>()) * model.diagonal;
}

std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan) {
  std::vector<FieldReport> reports;
  for (std::size_t field = 0; field < plan.size(); ++field) {
    FieldReport& report = reports.emplace_back();
    report.settings = to_json(plan[field].field.settings);
    for (const ModelDescription* model : models) {
      if (!model->fields[field].error.empty()) continue;
      ++report.models;
      report.seconds += model->fields[field].seconds;
      if (leaks(model->diagnostics, model->fields[field].offset, report.settings)) ++report.leaking;
      for (const auto& [outcome, count] : model->fields[field].outcomes) report.outcomes[outcome] += count;
    }
  }
  return reports;
}

ShapeReport report_shape(const ModelDescription& model) {
  ShapeReport report{.sha256 = model.sha256,
                     .diagnostics = model.diagnostics,
                     .chosen = model.chosen,
                     .area = model.area,
                     .noise = model.noise,
                     .pass_band = model.pass_band,
                     .outcomes = {},
                     .offsets = {},
                     .seconds = {},
                     .descriptor_seconds = {}};
  for (const FieldDescription& field : model.fields) {
    report.outcomes.push_back(field.outcomes);
    report.offsets.push_back(field.offset);
    report.seconds.push_back(field.seconds);
  }
  for (const FeatureDescription& descriptor : model.features) report.descriptor_seconds.push_back(descriptor.seconds);
  return report;
}

std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field) {
  if (wanted.range == HistogramRange::fixed) return std::vector(models.size(), wanted.fixed);
  if (wanted.range == HistogramRange::dataset) return std::vector(models.size(), common_range(models, field));
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return ranges;
}

namespace {

/// Returns the fields of the views, with the scales of pictures and histograms.
std::vector<ViewedField> viewed_fields_of(const ComputedSignatures& computed, std::span<const PlannedField> plan,
                                          const Configuration& configuration) {
  std::vector<ViewedField> viewed;
  for (const std::size_t i : viewed_fields(plan, configuration)) {
    const bool pictured = is_pictured(plan[i], configuration);
    const std::size_t signature = pictured ? configuration.report.pictured_signature : plan[i].signatures.front();
    ViewedField& field =
        viewed.emplace_back(ViewedField{.name = configuration.signatures[signature].name, .colours = {}});
    if (pictured)
      field.colours = configuration.report.picture_options.range;
    else if (configuration.signatures[signature].histogram.range != HistogramRange::per_shape) {
      field.colours = computed.histogram_ranges[signature].front();
    }
  }
  return viewed;
}

/// Returns the range of each field of the plan over all models of all ranks. Collective.
std::vector<Interval> ranges_over_data_set(const std::vector<const ModelDescription*>& own, std::size_t fields,
                                           Communicator& ranks) {
  Packer packer;
  for (std::size_t field = 0; field < fields; ++field) packer.add(ranges_of(own, field));
  const std::string told = on_first_rank(ranks, [parts = ranks.gather(std::move(packer).bytes()), fields] {
    std::vector<std::vector<Interval>> by_field(fields);
    for (const std::string& part : parts) {
      Unpacker unpacker(part);
      for (std::vector<Interval>& ranges : by_field) {
        const auto some = unpacker.take_value<std::vector<Interval>>();
        ranges.insert(ranges.end(), some.begin(), some.end());
      }
    }
    Packer enclosing;
    for (const std::vector<Interval>& ranges : by_field) enclosing.add(enclosing_interval(ranges));
    return std::move(enclosing).bytes();
  });
  std::vector<Interval> ranges(fields);
  Unpacker unpacker(told);
  for (Interval& range : ranges) unpacker.take(range);
  return ranges;
}

/// Returns the lengths of the signatures, of which some ranks may have no row. Throws if they differ. Collective.
std::vector<Eigen::Index> lengths_of(const std::vector<Signatures>& tables, Communicator& ranks) {
  Packer packer;
  for (const Signatures& table : tables) packer.add(table.cols());
  const std::string told =
      on_first_rank(ranks, [parts = ranks.gather(std::move(packer).bytes()), count = tables.size()] {
        std::vector<Eigen::Index> lengths(count);
        for (const std::string& part : parts) {
          Unpacker unpacker(part);
          for (Eigen::Index& length : lengths) {
            const auto other = unpacker.take_value<Eigen::Index>();
            if (length > 0 && other > 0 && length != other) throw different_lengths(other, length);
            length = std::max(length, other);
          }
        }
        return std::move(Packer().add(lengths)).bytes();
      });
  return Unpacker(told).take_value<std::vector<Eigen::Index>>();
}

/// Distributes rows to the ranks that they belong to; `tables` are those of the models at these positions. Collective.
std::vector<Signatures> rows_of_rank(std::vector<Signatures> tables, std::span<const std::size_t> places,
                                     std::size_t all, Communicator& ranks) {
  const std::vector<Eigen::Index> lengths = lengths_of(tables, ranks);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    if (tables[k].cols() == lengths[k]) continue;  // or no model of this rank has the signature
    tables[k].setConstant(tables[k].rows(), lengths[k], std::numeric_limits<float>::quiet_NaN());
  }
  std::vector<std::string> to_ranks;
  for (int rank = 0; rank < ranks.size(); ++rank) {
    const RankRange part = part_of_rank(all, rank, ranks.size());
    Packer packer;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i] < part.first || places[i] >= part.last) continue;
      packer.add(places[i]);
      for (std::size_t k = 0; k < tables.size(); ++k) {
        packer.add_bytes(tables[k].row(static_cast<Eigen::Index>(i)).data(),
                         static_cast<std::size_t>(lengths[k]) * sizeof(float));
      }
    }
    to_ranks.push_back(std::move(packer).bytes());
  }
  const RankRange own = part_of_rank(all, ranks.rank(), ranks.size());
  std::vector<Signatures> rows;
  for (const Eigen::Index length : lengths) rows.emplace_back(static_cast<Eigen::Index>(own.size()), length);
  for (const std::string& part : ranks.exchange(std::move(to_ranks))) {
    for (Unpacker unpacker(part); !unpacker.is_at_end();) {
      const auto row = static_cast<Eigen::Index>(unpacker.take_value<std::size_t>() - own.first);
      for (Signatures& table : rows) {
        unpacker.take_bytes(table.row(row).data(), static_cast<std::size_t>(table.cols()) * sizeof(float));
      }
    }
  }
  return rows;
}

/// Gathers the descriptions of all models on rank 0, in order, without values, histograms and features. Collective.
std::vector<ModelDescription> told_of_all(const std::vector<const ModelDescription*>& own,
                                          std::span<const std::size_t> places, std::size_t all, Communicator& ranks) {
  Packer packer;
  for (std::size_t i = 0; i < own.size(); ++i) packer.add(places[i]).add(described_bytes(*own[i]));
  std::vector<ModelDescription> models(ranks.rank() == 0 ? all : 0);
  for (const std::string& part : ranks.gather(std::move(packer).bytes())) {
    for (Unpacker unpacker(part); !unpacker.is_at_end();) {
      const auto place = unpacker.take_value<std::size_t>();
      models[place] = read_described(unpacker.take_value<std::string>());
    }
  }
  return models;
}

/// Adds the reports on models to the results.
void report(std::vector<ModelDescription> models, const Configuration& configuration,
            std::span<const PlannedField> plan, ComputedSignatures& computed) {
  std::vector<const ModelDescription*> all;
  for (const ModelDescription& model : models) all.push_back(&model);
  computed.histogram_ranges.resize(configuration.signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      computed.histogram_ranges[i] = histogram_ranges(all, configuration.signatures[i].histogram, field);
    }
  }
  computed.fields = report_fields(all, plan);
  for (ModelDescription& model : models) {
    computed.shapes.push_back(report_shape(model));
    computed.pictures.push_back(std::move(model.picture));
    computed.views.push_back(std::move(model.view));
  }
  for (std::vector<std::string>* drawings : {&computed.pictures, &computed.views}) {
    if (std::ranges::all_of(*drawings, &std::string::empty)) drawings->clear();
  }
  if (!computed.views.empty()) computed.viewed = viewed_fields_of(computed, plan, configuration);
}

}  // namespace

ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunControl& control, Cache& cache, Communicator& ranks) {
  const std::vector<PlannedField> plan = plan_fields(configuration.signatures);
  Described described = describe_models(dataset, configuration, control, plan, cache, ranks);
  ComputedSignatures computed;
  computed.models = models_without(described.failures, dataset.models.size());
  computed.failures = std::move(described.failures);
  computed.own = part_of_rank(computed.models.size(), ranks.rank(), ranks.size());

  const auto place_of = [&](std::size_t index) {
    return static_cast<std::size_t>(std::ranges::lower_bound(computed.models, index) - computed.models.begin());
  };
  std::vector<const ModelDescription*> models;
  std::vector<std::size_t> places;
  for (const auto& [index, model] : described.models) {
    models.push_back(&model);
    places.push_back(place_of(index));
  }
  computed.without = std::move(described.without);
  for (std::vector<ModelFailure>& failures : computed.without) {
    for (ModelFailure& failure : failures) failure.model = place_of(failure.model);
  }
  const std::vector<Interval> ranges = ranges_over_data_set(models, plan.size(), ranks);
  std::vector<Signatures> tables =
      on_all_ranks(ranks, [&] { return assemble_signatures(models, plan, configuration.signatures, ranges); });
  computed.field_ranges = ranges;
  computed.learnt = std::move(described.learnt);
  computed.signatures = rows_of_rank(std::move(tables), places, computed.models.size(), ranks);
  std::vector<ModelDescription> told = told_of_all(models, places, computed.models.size(), ranks);
  if (ranks.rank() == 0) report(std::move(told), configuration, plan, computed);
  return computed;
}

std::vector<std::string> field_warnings(std::span<const FieldReport> fields) {
  std::vector<std::string> warnings;
  for (const FieldReport& field : fields) {
    if (field.leaking > 0) {
      warnings.push_back(fmt::format(
          R"({} of {} shapes have gaps wider than the offset of the field {}: the offset surface leaks into them; )"
          R"(use a larger offset or "auto")",
          field.leaking, field.models, field.settings.dump()));
    }
    for (const std::string& warning : outcome_warnings(field.outcomes)) {
      warnings.push_back(fmt::format("{} in the field {}", warning, field.settings.dump()));
    }
  }
  return warnings;
}

}  // namespace shapegauge
