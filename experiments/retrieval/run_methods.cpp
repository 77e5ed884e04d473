#include "shapegauge/experiments/retrieval/run_methods.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"
#include "shapegauge/experiments/retrieval/models_with_signature.h"
#include "shapegauge/experiments/signatures/distances_through_cache.h"
#include "shapegauge/experiments/signatures/signature_tables.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

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

/// Computes derived distances between the models that have all parts, and the remark on them.
DistanceMatrix derived_distances(const SignatureConfiguration& signature, const std::vector<DistanceMatrix>& distances,
                                 const ModelsWithSignature& holders, std::string& remark) {
  std::vector<DistanceMatrix> parts;
  for (const std::size_t part : signature.parts) {
    const DistanceMatrix& all = distances[part];
    parts.push_back(holders.are_all() ? all : DistanceMatrix(all(holders.places(), holders.places())));
  }
  try {
    if (signature.derived->remark) remark = signature.derived->remark(parts);
    return signature.derived->compute(parts);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("signature \"{}\": {}", signature.name, error.what()));
  }
}

/// Distances and evaluations of all methods of a run.
class MethodsRun {
 public:
  MethodsRun(const Configuration& configuration, const std::vector<fs::path>& distance_files, const RunContext& context)
      : configuration_(&configuration),
        distance_files_(&distance_files),
        context_(&context),
        ranks_(&context.ranks),
        in_derived_(taking_part_in_derived(configuration.signatures)),
        whole_(configuration.signatures.size()),
        remarks_(configuration.signatures.size()) {}

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
      if (context_->control.interrupted()) throw Interrupted();
      results.methods.push_back({.name = configuration_->signatures[i].name,
                                 .distances = {},
                                 .overview = {},
                                 .evaluations = {},
                                 .failures = std::move(computed.without[i]),
                                 .signatures = {},
                                 .histogram_ranges = {},
                                 .remark = remarks_[i]});
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
    return configuration_->keep_distances && distance_files_->empty() && ranks_->size() == 1;
  }

  /// Returns true if rank 0 needs the whole distance matrix of a signature.
  [[nodiscard]] bool is_whole(std::size_t signature, std::size_t models) const {
    const bool few = models <= static_cast<std::size_t>(most_models_of_cached_distances);
    return in_derived_[signature] || keeps_matrices() || (ranks_->size() == 1 && few);
  }

  /// Computes the matrices needed in memory. Collective.
  void compute_whole(const ComputedSignatures& computed, std::size_t models) {
    std::size_t done = 0;
    for (const std::size_t i : computation_order(configuration_->signatures)) {
      if (context_->control.interrupted()) throw Interrupted();
      context_->control.progress("distances", done++, whole_.size());
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
  [[nodiscard]] DistanceMatrix whole_matrix(std::size_t i, const Signatures& all) {
    const SignatureConfiguration& signature = configuration_->signatures[i];
    const ModelsWithSignature& holders = holders_[i];
    if (signature.derived) return holders.spread(derived_distances(signature, whole_, holders, remarks_[i]));
    const auto distances_of = [&](const Signatures& table) {
      return signature.descriptor ? distances_through_cache(table, signature.descriptor->descriptor, context_->cache)
                                  : distances_through_cache(table, configuration_->distance, context_->cache);
    };
    return holders.are_all() ? distances_of(all) : holders.spread(distances_of(all(holders.places(), Eigen::all)));
  }

  /// Evaluates the distances of one signature; returns the seconds of evaluation on this rank. Collective.
  double judge(std::size_t i, const std::vector<int>& labels, const Signatures& rows, MethodResults& method) {
    const bool whole = is_whole(i, labels.size());
    const RankRange streamed = part_of_rank(labels.size(), ranks_->rank(), ranks_->size());
    const bool has_gaps = !whole && !holders_[i].are_all();
    const Signatures filled = has_gaps ? holders_[i].with_stand_ins(rows, streamed, *ranks_) : Signatures();
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
      if (context_->control.interrupted()) throw Interrupted();
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
    if (configuration_->keep_distances && !distance_files_->empty()) wanted.file = (*distance_files_)[i];
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
  const std::vector<fs::path>* distance_files_;
  const RunContext* context_;
  Communicator* ranks_;
  std::vector<bool> in_derived_;              ///< by signature
  std::vector<int> subclasses_;               ///< of the models; empty: none
  std::vector<DistanceMatrix> whole_;         ///< by signature; on rank 0
  std::vector<std::string> remarks_;          ///< by signature; on rank 0
  std::vector<ModelsWithSignature> holders_;  ///< by signature
};

}  // namespace

void run_methods(const Configuration& configuration, const std::vector<fs::path>& distance_files,
                 const RunContext& context, ComputedSignatures& computed, ExperimentResults& results) {
  MethodsRun(configuration, distance_files, context).run(computed, results);
}

}  // namespace shapegauge
