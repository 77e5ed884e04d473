#include "shapegauge/experiments/signatures/compute_signatures.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <mutex>
#include <tbb/task_arena.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/cache_records.h"
#include "shapegauge/experiments/signatures/describe_learnt.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/describe_through_cache.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

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

void stop_on_failures(const Dataset& dataset, const std::vector<ModelFailure>& failures, OnError on_error) {
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

Described describe_models(const Dataset& dataset, const Configuration& configuration,
                          std::span<const PlannedField> plan, const RunContext& context) {
  Communicator& ranks = context.ranks;
  Described described;
  described.failures = failures_of_all(ranks.rank() == 0 ? check_models(dataset) : std::vector<ModelFailure>(), ranks);
  stop_on_failures(dataset, described.failures, configuration.on_error);
  const std::vector<std::size_t> remaining = models_without(described.failures, dataset.models.size());
  // Processing shapes in parallel needs no synchronisation, but a few shapes do not occupy all threads.
  const auto threads =
      static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) * static_cast<std::size_t>(ranks.size());
  const bool parallel_within = remaining.size() < 2 * threads;
  const bool stops = configuration.on_error == OnError::stop;
  std::mutex mutex;
  const std::vector<ModelFailure> failures =
      for_each_model(remaining, "signatures", stops, context.control, ranks, [&](std::size_t model) {
        ModelDescription description =
            describe_through_cache(dataset, model, configuration, plan, parallel_within, context.cache);
        const std::scoped_lock lock(mutex);
        described.models.emplace(model, std::move(description));
      });
  const auto add = [&](std::vector<ModelFailure> more) {
    if (stops && more.size() > 1) more.resize(1);
    described.failures.insert(described.failures.end(), more.begin(), more.end());
    std::ranges::sort(described.failures, {}, &ModelFailure::model);
    stop_on_failures(dataset, described.failures, configuration.on_error);
  };
  add(failures_of_all(failures, ranks));
  check_signatures_exist(dataset, configuration.signatures, described, plan, ranks);
  add(describe_learnt(described.models, configuration, plan, context, described.learnt));
  const std::vector<ModelFailure> useless = without_signatures(described.models, configuration.signatures, plan);
  for (const ModelFailure& failure : useless) described.models.erase(failure.model);
  add(failures_of_all(useless, ranks));
  check_signatures_exist(dataset, configuration.signatures, described, plan, ranks);
  return described;
}

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
  for (std::size_t field = 0; field < fields; ++field) packer.add(model_ranges(own, field));
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
            if (length > 0 && other > 0 && length != other) throw different_feature_counts(length, other);
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
    // Otherwise it is derived from distances, or no model of this rank has it.
    if (tables[k].rows() == std::ssize(places) && tables[k].cols() == lengths[k]) continue;
    tables[k].setConstant(std::ssize(places), lengths[k], std::numeric_limits<float>::quiet_NaN());
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
std::vector<ModelDescription> descriptions_on_first_rank(const std::vector<const ModelDescription*>& own,
                                                         std::span<const std::size_t> places, std::size_t all,
                                                         Communicator& ranks) {
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
                                      const RunContext& context) {
  Communicator& ranks = context.ranks;
  const std::vector<PlannedField> plan = plan_fields(configuration.signatures);
  Described described = describe_models(dataset, configuration, plan, context);
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
  std::vector<ModelDescription> all = descriptions_on_first_rank(models, places, computed.models.size(), ranks);
  if (ranks.rank() == 0) report(std::move(all), configuration, plan, computed);
  return computed;
}

}  // namespace shapegauge
