#include "shapegauge/experiments/retrieval/run_experiment.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <limits>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "shapegauge/experiments/engine/generated_dataset.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"
#include "shapegauge/experiments/signatures/cache_records.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

constexpr Eigen::Index most_shapes_kept = 2900;

std::vector<int> labels_of(const std::vector<Model>& models) {
  std::vector<int> labels;
  labels.reserve(models.size());
  for (const Model& model : models) labels.push_back(model.label);
  return labels;
}

std::vector<int> subclasses_of(const std::vector<Model>& models) {
  std::vector<std::string> names;
  names.reserve(models.size());
  for (const Model& model : models) names.push_back(model.subclass);
  return numbered_subclasses(names);
}

/// By signature: true if its distances are derived or others derive from them, which needs whole matrices.
std::vector<bool> taking_part_in_derived(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<bool> takes_part(signatures.size());
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (!signatures[i].derived) continue;
    takes_part[i] = true;
    for (const std::size_t part : signatures[i].parts) takes_part[part] = true;
  }
  return takes_part;
}

/// Returns all rows of the signatures on rank 0, none elsewhere. Collective.
Signatures gathered(const Signatures& rows, std::size_t all, Communicator& ranks) {
  if (ranks.size() == 1) return rows;
  std::string bytes = std::move(Packer().add(rows)).bytes();
  const std::vector<std::string> parts = ranks.gather(std::move(bytes));
  Signatures together(ranks.rank() == 0 ? static_cast<Eigen::Index>(all) : 0, rows.cols());
  Eigen::Index first = 0;
  for (const std::string& part : parts) {
    const auto some = Unpacker(part).take_value<Signatures>();
    together.middleRows(first, some.rows()) = some;
    first += some.rows();
  }
  return together;
}

/// Models with a signature, by position.
class Holders {
 public:
  Holders() = default;

  Holders(const std::vector<ModelFailure>& without, std::size_t all) : is_in_(all, true) {
    for (const ModelFailure& failure : without) is_in_[failure.model] = false;
    for (std::size_t i = 0; i < all; ++i) {
      if (is_in_[i]) places_.push_back(static_cast<Eigen::Index>(i));
    }
  }

  [[nodiscard]] bool are_all() const { return places_.size() == is_in_.size(); }
  [[nodiscard]] const std::vector<Eigen::Index>& places() const { return places_; }

  /// Returns the distances between all models from those between the ones with the signature: all others are
  /// infinitely far.
  [[nodiscard]] DistanceMatrix spread(DistanceMatrix between) const {
    if (are_all()) return between;
    const auto all = std::ssize(is_in_);
    DistanceMatrix distances = DistanceMatrix::Constant(all, all, std::numeric_limits<double>::infinity());
    distances(places_, places_) = between;
    distances.diagonal().setZero();
    return distances;
  }

  /// Makes the distances to and from models without the signature infinite; the first row is that of model `first`.
  void set_infinite(DistanceMatrix& rows, Eigen::Index first) const {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      for (Eigen::Index j = 0; j < rows.cols(); ++j) {
        if (is_in_[static_cast<std::size_t>(first + i)] && is_in_[static_cast<std::size_t>(j)]) continue;
        rows(i, j) = first + i == j ? 0 : std::numeric_limits<double>::infinity();
      }
    }
  }

 private:
  std::vector<bool> is_in_;
  std::vector<Eigen::Index> places_;
};

/// Computes derived distances between the models that have all parts.
DistanceMatrix derived_distances(const SignatureConfiguration& signature, const std::vector<DistanceMatrix>& distances,
                                 const Holders& holders) {
  std::vector<DistanceMatrix> parts;
  for (const std::size_t part : signature.parts) {
    const DistanceMatrix& all = distances[part];
    parts.push_back(holders.are_all() ? all : DistanceMatrix(all(holders.places(), holders.places())));
  }
  try {
    return signature.derived->compute(parts);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("signature \"{}\": {}", signature.name, error.what()));
  }
}

/// Returns the rows of this rank with those of models without the signature replaced by the row of another model, so
/// that all have distances. Collective.
Signatures with_stand_ins(const Signatures& rows, const RankRange& own, const Holders& holders, Communicator& ranks) {
  const auto first = static_cast<std::size_t>(holders.places().front());
  const bool is_here = first >= own.first && first < own.last;
  const auto local = static_cast<Eigen::Index>(first - own.first);
  std::string told;
  for (const std::string& part :
       ranks.gather(is_here ? std::move(Packer().add(Signatures(rows.row(local)))).bytes() : std::string())) {
    if (!part.empty()) told = part;
  }
  const auto stand_in = Unpacker(ranks.broadcast(std::move(told))).take_value<Signatures>();
  Signatures filled = rows;
  for (Eigen::Index i = 0; i < filled.rows(); ++i) {
    const auto model = static_cast<Eigen::Index>(own.first) + i;
    if (!std::ranges::binary_search(holders.places(), model)) filled.row(i) = stand_in.row(0);
  }
  return filled;
}

/// Distances and evaluations of all methods of a run.
class MethodsRun {
 public:
  MethodsRun(const Configuration& configuration, const RunPlaces& places, const RunControl& control, Cache& cache,
             Communicator& ranks)
      : configuration_(&configuration),
        places_(&places),
        control_(&control),
        cache_(&cache),
        ranks_(&ranks),
        in_derived_(taking_part_in_derived(configuration.signatures)),
        whole_(configuration.signatures.size()) {}

  /// Adds the methods and, on rank 0, their results. Collective.
  void run(ComputedSignatures& computed, ExperimentResults& results) {
    const std::vector<int> labels = labels_of(results.models);
    subclasses_ = subclasses_of(results.models);
    check_size(labels.size());
    for (const std::vector<ModelFailure>& without : computed.without) holders_.emplace_back(without, labels.size());
    double evaluating = 0;
    Stopwatch stopwatch;
    compute_whole(computed, labels.size());
    for (std::size_t i = 0; i < configuration_->signatures.size(); ++i) {
      if (control_->interrupted()) throw Interrupted();
      results.methods.push_back({.name = configuration_->signatures[i].name,
                                 .distances = {},
                                 .overview = {},
                                 .evaluations = {},
                                 .failures = std::move(computed.without[i]),
                                 .signatures = {},
                                 .histogram_ranges = {}});
      evaluating += judge(i, labels, computed.signatures[i], results.methods.back());
      results.methods.back().signatures = kept_signatures(i, labels.size(), std::move(computed.signatures[i]));
      if (!computed.histogram_ranges.empty()) {
        results.methods.back().histogram_ranges = std::move(computed.histogram_ranges[i]);
      }
    }
    results.timings.emplace_back("distances", stopwatch.lap() - evaluating);
    results.timings.emplace_back("evaluation", evaluating);
  }

 private:
  void check_size(std::size_t models) const {
    const auto derived = std::ranges::find(in_derived_, true);
    if (ranks_->size() == 1 || models <= most_models_of_derived_distances || derived == in_derived_.end()) return;
    throw SharedError(fmt::format(
        "sum, fuse_ranks and rerank need whole distance matrices, which several processes support for up to {} models, "
        "not {}; remove the signature \"{}\" and others like it, or run in one process with enough memory",
        most_models_of_derived_distances, models,
        configuration_->signatures[static_cast<std::size_t>(derived - in_derived_.begin())].name));
  }

  [[nodiscard]] bool keeps_matrices() const {
    return configuration_->keep_distances && places_->distance_files.empty() && ranks_->size() == 1;
  }

  /// Returns true if rank 0 needs the whole distance matrix of a signature.
  [[nodiscard]] bool is_whole(std::size_t signature, std::size_t models) const {
    const bool few = models <= static_cast<std::size_t>(most_shapes_kept);
    return in_derived_[signature] || keeps_matrices() || (ranks_->size() == 1 && few);
  }

  /// Computes the matrices needed in memory. Collective.
  void compute_whole(const ComputedSignatures& computed, std::size_t models) {
    std::size_t done = 0;
    for (const std::size_t i : computation_order(configuration_->signatures)) {
      if (control_->interrupted()) throw Interrupted();
      control_->progress("distances", done++, whole_.size());
      if (!is_whole(i, models)) continue;
      const SignatureConfiguration& signature = configuration_->signatures[i];
      const Signatures rows =
          signature.derived || ranks_->size() == 1 ? Signatures() : gathered(computed.signatures[i], models, *ranks_);
      const Signatures& all = ranks_->size() == 1 ? computed.signatures[i] : rows;
      on_all_ranks(*ranks_, [&] {
        if (ranks_->rank() == 0) whole_[i] = whole_matrix(i, all);
      });
    }
  }

  /// Computes the distances by one signature; `all` are the signatures of all models, unless it is derived.
  [[nodiscard]] DistanceMatrix whole_matrix(std::size_t i, const Signatures& all) const {
    const SignatureConfiguration& signature = configuration_->signatures[i];
    const Holders& holders = holders_[i];
    if (signature.derived) return holders.spread(derived_distances(signature, whole_, holders));
    const auto distances_of = [&](const Signatures& table) {
      return signature.descriptor ? distances_through_cache(table, signature.descriptor->descriptor, *cache_)
                                  : distances_through_cache(table, configuration_->distance, *cache_);
    };
    return holders.are_all() ? distances_of(all) : holders.spread(distances_of(all(holders.places(), Eigen::all)));
  }

  /// Evaluates the distances of one signature; returns the seconds of evaluation on this rank. Collective.
  double judge(std::size_t i, const std::vector<int>& labels, const Signatures& rows, MethodResults& method) {
    const bool whole = is_whole(i, labels.size());
    const RankRange streamed = part_of_rank(labels.size(), ranks_->rank(), ranks_->size());
    const bool has_gaps = !whole && !holders_[i].are_all();
    const Signatures filled = has_gaps ? with_stand_ins(rows, streamed, holders_[i], *ranks_) : Signatures();
    const SharedSignatures signatures{.rows = has_gaps ? filled : rows, .all = labels.size()};
    const NamedDistance distance = distance_between(configuration_->signatures[i], *configuration_);
    JudgedMethod wanted = judged_method(i);
    if (wanted.overview && std::ssize(labels) > largest_heat_map) {
      wanted.largest = whole ? largest_of_whole(whole_[i], holders_[i].places().front())
                             : largest_of_first(distance, signatures, *ranks_);
    }
    const RankRange all_on_first{.first = ranks_->rank() == 0 ? 0 : labels.size(), .last = labels.size()};
    DistanceJudge judge(labels, whole ? all_on_first : streamed, wanted, *ranks_);
    const RowVisitor add = [&](Eigen::Index first, const DistanceTable& some) {
      if (control_->interrupted()) throw Interrupted();
      if (!has_gaps) return judge.add(first, some);
      DistanceMatrix rows_with_gaps = some;
      holders_[i].set_infinite(rows_with_gaps, first);
      judge.add(first, rows_with_gaps);
    };
    if (whole) {
      add_whole(whole_[i], add);
    } else {
      visit_distances(distance, signatures, *ranks_, add);
    }
    Judgement judgement = judge.finish();
    method.evaluations = std::move(judgement.evaluations);
    if (judgement.overview) method.overview = std::move(*judgement.overview);
    DistanceMatrix matrix = std::move(whole_[i]);
    if (keeps_matrices()) method.distances = std::move(matrix);
    return judge.seconds();
  }

  /// Returns what is wanted of the distances by one signature.
  [[nodiscard]] JudgedMethod judged_method(std::size_t i) const {
    JudgedMethod wanted;
    for (const Protocol protocol : configuration_->protocols) {
      wanted.evaluations.push_back({.protocol = protocol,
                                    .ties = configuration_->ties,
                                    .measures = configuration_->measures,
                                    .minimum_class_size = configuration_->minimum_class_size});
    }
    wanted.subclasses = subclasses_;
    wanted.overview = configuration_->report.wanted;
    if (configuration_->keep_distances && !places_->distance_files.empty()) wanted.file = places_->distance_files[i];
    return wanted;
  }

  static double largest_of_whole(const DistanceMatrix& distances, Eigen::Index row) {
    return largest_finite({distances.row(row).data(), static_cast<std::size_t>(distances.cols())}, row);
  }

  static void add_whole(const DistanceMatrix& distances, const RowVisitor& add) {
    constexpr Eigen::Index together = 1024;
    for (Eigen::Index first = 0; first < distances.rows(); first += together) {
      add(first, distances.middleRows(first, std::min(together, distances.rows() - first)));
    }
  }

  /// Returns the signatures for the results. Collective.
  Signatures kept_signatures(std::size_t i, std::size_t models, Signatures rows) {
    if (ranks_->size() == 1) return rows;
    const SignatureConfiguration& signature = configuration_->signatures[i];
    const bool shown = signature.field && configuration_->report.wanted;
    return signature.descriptor || shown ? gathered(rows, models, *ranks_) : Signatures();
  }

  const Configuration* configuration_;
  const RunPlaces* places_;
  const RunControl* control_;
  Cache* cache_;
  Communicator* ranks_;
  std::vector<bool> in_derived_;       ///< by signature
  std::vector<int> subclasses_;        ///< of the models; empty: none
  std::vector<DistanceMatrix> whole_;  ///< by signature; on rank 0
  std::vector<Holders> holders_;       ///< by signature
};

/// Finds or generates the data set of the configuration; a generated one goes into the given folder. Collective.
Dataset prepare_dataset(const Configuration& configuration, const fs::path& generated_folder, const RunControl& control,
                        Communicator& ranks) {
  if (configuration.generator) prepare_generated(generated_folder, *configuration.generator, control, ranks);
  return on_all_ranks(ranks, [&] {
    if (!configuration.generator) return find_dataset(configuration.location.value());
    return find_dataset(
        {.layout = "shrec11", .root = generated_folder, .classification = generated_folder / "test.cla"});
  });
}

void run_stages(const Configuration& configuration, const RunPlaces& places, const RunControl& control, Cache& cache,
                Communicator& ranks, ExperimentResults& results) {
  Stopwatch stopwatch;
  const Dataset dataset = prepare_dataset(configuration, places.generated_folder, control, ranks);
  results.timings.emplace_back("dataset", stopwatch.lap());

  ComputedSignatures computed = compute_signatures(dataset, configuration, control, cache, ranks);
  results.classes = dataset.classes;
  results.skipped = dataset.skipped;
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

  MethodsRun(configuration, places, control, cache, ranks).run(computed, results);
}

}  // namespace

namespace {

/// Returns the distances of the signatures from the cache, or by `compute`.
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

ExperimentResults run_experiment(const Configuration& configuration, const RunPlaces& places, const RunControl& control,
                                 Cache& cache, Communicator& ranks) {
  ExperimentResults results;
  results.processes = ranks.size();
  results.configuration = configuration;
  results.threads = control.threads > 0 ? control.threads : available_threads();
  with_threads(control, [&] { run_stages(configuration, places, control, cache, ranks, results); });
  results.cache = report_of(cache, ranks);
  return results;
}

ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control) {
  Cache none;
  return run_experiment(configuration, {.generated_folder = generated_folder, .distance_files = {}}, control, none,
                        *single_process());
}

namespace {

/// Names the first few models with their reasons.
std::string names_with_reasons(const std::vector<ModelFailure>& failures, const std::vector<Model>& models) {
  constexpr std::size_t most = 3;
  std::vector<std::string> parts;
  for (const ModelFailure& failure : failures) {
    if (parts.size() == most) break;
    parts.push_back(fmt::format("{} ({})", models[failure.model].id, failure.message));
  }
  const std::string others = failures.size() > most ? fmt::format(" and {} more", failures.size() - most) : "";
  return fmt::format("{}{}", fmt::join(parts, ", "), others);
}

/// Describes the effect of ties on FT under each protocol: "FT 52.5 to 81.0 (psb)"; empty if there is none.
std::string effect_on_first_tier(const MethodResults& method) {
  std::vector<std::string> parts;
  for (const Evaluation& evaluation : method.evaluations) {
    const auto& [pessimistic, optimistic] = evaluation.first_tier_bounds;
    if (pessimistic == optimistic) continue;
    parts.push_back(
        fmt::format("{:.1f} to {:.1f} ({})", 100 * pessimistic, 100 * optimistic, name_of(evaluation.protocol)));
  }
  return parts.empty() ? "" : fmt::format("; FT ranges from {} with their order", fmt::join(parts, ", "));
}

}  // namespace

std::vector<std::string> incomplete_methods(const ExperimentResults& results) {
  std::vector<std::string> sentences;
  for (const MethodResults& method : results.methods) {
    if (method.failures.empty()) continue;
    sentences.push_back(fmt::format("method \"{}\" cannot take {} of {} models, which count as not found: {}",
                                    method.name, method.failures.size(), results.models.size(),
                                    names_with_reasons(method.failures, results.models)));
  }
  return sentences;
}

std::vector<std::string> run_warnings(const ExperimentResults& results) {
  std::vector<std::string> warnings = field_warnings(results.fields);
  for (const MethodResults& method : results.methods) {
    // Without external ranked lists, all protocols have the same tied queries.
    const Evaluation& evaluation = method.evaluations.front();
    if (evaluation.queries_with_ties == 0) continue;
    warnings.push_back(fmt::format(
        "method \"{}\": {} of {} queries have relevant and other models at equal distance, ordered by \"ties\": "
        "\"{}\"{}",
        method.name, evaluation.queries_with_ties, evaluation.queries.size(), name_of(evaluation.ties),
        effect_on_first_tier(method)));
  }
  return warnings;
}

}  // namespace shapegauge
