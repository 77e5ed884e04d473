// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/run_methods.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/cache/codec.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"
#include "shapegauge/experiments/retrieval/models_with_signature.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "shapegauge/metrics/distance_overview.h"

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
  return number_subclasses(names);
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

/// Computes derived distances between the models that have all parts, and the remark on them.
DistanceMatrix derived_distances(const SignatureConfiguration& signature, const std::vector<DistanceMatrix>& distances,
                                 const ModelsWithSignature& holders, std::string& remark) {
  std::vector<DistanceMatrix> parts;
  for (const std::size_t part : signature.parts) {
    const DistanceMatrix& all = distances[part];
    parts.push_back(holders.has_all_models() ? all : DistanceMatrix(all(holders.indices(), holders.indices())));
  }
  try {
    remark = remark_on(*signature.derived, parts);
    return derive(*signature.derived, parts);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("signature \"{}\": {}", signature.name, error.what()));
  }
}

/// Returns true if the whole distance matrix of a signature is in memory, of which `in_derived` tells whether it takes
/// part in derived distances.
bool is_in_memory(bool in_derived, std::size_t models) {
  return in_derived || models <= static_cast<std::size_t>(max_models_of_cached_distances);
}

/// Number of rows of streamed distances whose scores are stored together.
constexpr Eigen::Index rows_of_entry = 512;

/// Cache version of the scores of rows; increment when ranked lists or curves change.
constexpr int row_scores_version = 1;

/// Distances and evaluations of all methods of a run.
class MethodsRun {
 public:
  MethodsRun(const Configuration& configuration, const std::vector<fs::path>& distance_files, const RunContext& context,
             const std::vector<Model>& models, const std::vector<std::vector<ModelFailure>>& without)
      : configuration_(&configuration),
        distance_files_(&distance_files),
        context_(&context),
        labels_(labels_of(models)),
        task_(leave_one_out(labels_)),
        in_derived_(taking_part_in_derived(configuration.signatures)),
        whole_(configuration.signatures.size()),
        remarks_(configuration.signatures.size()) {
    task_.query_subclasses = task_.target_subclasses = subclasses_of(models);
    for (const std::vector<ModelFailure>& of_signature : without) holders_.emplace_back(of_signature, labels_.size());
    for (const Protocol protocol : configuration.protocols) {
      evaluations_.push_back(configuration.evaluation);
      evaluations_.back().protocol = protocol;
    }
  }

  /// Adds the methods and their results.
  void run(ComputedSignatures& computed, ExperimentResults& results) {
    double evaluating = 0;
    Stopwatch stopwatch;
    compute_whole(computed);
    for (std::size_t i = 0; i < configuration_->signatures.size(); ++i) {
      stop_if_interrupted();
      MethodResults& method = results.methods.emplace_back();
      method.name = configuration_->signatures[i].name;
      method.failures = std::move(computed.without[i]);
      method.remark = remarks_[i];
      evaluating += judge(i, computed.signatures[i], method);
      method.signatures = std::move(computed.signatures[i]);
      method.histogram_ranges = std::move(computed.histogram_ranges[i]);
    }
    results.timings.emplace_back("distances", stopwatch.lap() - evaluating);
    results.timings.emplace_back("evaluation", evaluating);
  }

  /// Evaluates the part's rows of the streamed distances through the cache; returns their number.
  std::size_t run_part(const ComputedSignatures& computed, const Part& part) {
    std::size_t rows = 0;
    double seconds = 0;
    for (std::size_t i = 0; i < configuration_->signatures.size(); ++i) {
      if (is_in_memory(in_derived_[i], labels_.size())) continue;
      const StreamedRows streamed = streamed_rows(i, computed.signatures[i]);
      std::size_t entry = 0;
      for (const RowRange& some : entries()) {
        if (!part.has(entry++)) continue;
        (void)scores_of(streamed, some, nullptr, seconds);
        rows += static_cast<std::size_t>(some.last - some.first);
      }
    }
    return rows;
  }

 private:
  /// Distances of a signature, computed by rows.
  struct StreamedRows {
    std::size_t signature;
    NamedDistance distance;
    Signatures rows;  ///< with stand-ins for models without the signature
    std::string key;  ///< of all that the distances depend on
  };

  void stop_if_interrupted() const {
    if (context_->control.interrupted()) throw Interrupted();
  }

  [[nodiscard]] bool keeps_matrices() const { return configuration_->keep_distances && distance_files_->empty(); }
  [[nodiscard]] bool is_whole(std::size_t signature) const {
    return keeps_matrices() || is_in_memory(in_derived_[signature], labels_.size());
  }

  /// Computes the matrices needed in memory.
  void compute_whole(const ComputedSignatures& computed) {
    std::size_t done = 0;
    for (const std::size_t i : computation_order(configuration_->signatures)) {
      stop_if_interrupted();
      context_->control.progress("distances", done++, whole_.size());
      if (is_whole(i)) whole_[i] = whole_matrix(i, computed.signatures[i]);
    }
  }

  /// Computes the distances by one signature; `all` are the signatures of all models, unless it is derived.
  [[nodiscard]] DistanceMatrix whole_matrix(std::size_t i, const Signatures& all) {
    const SignatureConfiguration& signature = configuration_->signatures[i];
    const ModelsWithSignature& holders = holders_[i];
    if (signature.derived) return holders.spread(derived_distances(signature, whole_, holders, remarks_[i]));
    const auto distances_of = [&](const Signatures& table) {
      return distances_through_cache(table, distance_between(signature, *configuration_), context_->cache);
    };
    return holders.has_all_models() ? distances_of(all)
                                    : holders.spread(distances_of(all(holders.indices(), Eigen::all)));
  }

  [[nodiscard]] StreamedRows streamed_rows(std::size_t i, const Signatures& rows) const {
    NamedDistance distance = distance_between(configuration_->signatures[i], *configuration_);
    std::string key = distances_key(rows, distance.name);
    return {.signature = i,
            .distance = std::move(distance),
            .rows = holders_[i].has_all_models() ? rows : holders_[i].with_placeholder_rows(rows),
            .key = std::move(key)};
  }

  /// Passes rows of the distances to the visitor.
  void visit(const StreamedRows& streamed, const RowRange& rows, const RowVisitor& visitor) const {
    const ModelsWithSignature& holders = holders_[streamed.signature];
    visit_distances(streamed.distance, streamed.rows, rows, [&](Eigen::Index first, const DistanceTable& some) {
      stop_if_interrupted();
      if (holders.has_all_models()) return visitor(first, some);
      DistanceMatrix rows_with_gaps = some;
      holders.set_infinite(rows_with_gaps, first);
      visitor(first, rows_with_gaps);
    });
  }

  /// Returns the ranges of rows whose scores are stored together.
  [[nodiscard]] std::vector<RowRange> entries() const {
    std::vector<RowRange> ranges;
    const Eigen::Index all = std::ssize(labels_);
    for (Eigen::Index first = 0; first < all; first += rows_of_entry) {
      ranges.push_back({.first = first, .last = std::min(first + rows_of_entry, all)});
    }
    return ranges;
  }

  [[nodiscard]] std::string key_of_scores(const StreamedRows& streamed, const RowRange& rows) const {
    const EvaluationOptions& evaluation = configuration_->evaluation;
    std::vector<std::string> measures;
    for (const Measure& measure : evaluation.measures) measures.push_back(measure.name);
    std::vector<std::string> protocols;
    for (const Protocol protocol : configuration_->protocols) protocols.push_back(name_of(protocol));
    return result_key(EntryKind::evaluation, {{"distances", streamed.key},
                                              {"labels", sha256(encode(labels_))},
                                              {"subclasses", sha256(encode(task_.query_subclasses))},
                                              {"protocols", protocols},
                                              {"ties", name_of(evaluation.ties)},
                                              {"measures", measures},
                                              {"measure_versions", measure_versions(evaluations_.front())},
                                              {"minimum_class_size", evaluation.minimum_class_size},
                                              {"rows", {rows.first, rows.last}},
                                              {"version", row_scores_version}});
  }

  /// Returns the scores of some rows through the cache. All these rows are passed to `also`, if there is one.
  RowScores scores_of(const StreamedRows& streamed, const RowRange& rows, const RowVisitor& also, double& seconds) {
    bool found = true;
    RowScores scores = context_->cache.get(EntryKind::evaluation, key_of_scores(streamed, rows), [&] {
      found = false;
      const auto visit_rows = [&](const RowVisitor& judge) {
        visit(streamed, rows, [&](Eigen::Index first, const DistanceTable& some) {
          judge(first, some);
          if (also) also(first, some);
        });
      };
      return evaluate_row_range(task_, evaluations_, rows, visit_rows, seconds);
    });
    if (found && also) visit(streamed, rows, also);
    return scores;
  }

  /// Returns the scores of a whole matrix. All its rows are passed to `also`, if there is one.
  RowScores scores_of_whole(const DistanceMatrix& distances, const RowVisitor& also, double& seconds) {
    const Eigen::Index all = distances.rows();
    const auto visit_rows = [&](const RowVisitor& judge) {
      constexpr Eigen::Index together = 1024;
      for (Eigen::Index first = 0; first < all; first += together) {
        const auto some = distances.middleRows(first, std::min(together, all - first));
        judge(first, some);
        if (also) also(first, some);
      }
    };
    return evaluate_row_range(task_, evaluations_, {.first = 0, .last = all}, visit_rows, seconds);
  }

  /// Evaluates the distances of one signature; returns the seconds of evaluation.
  double judge(std::size_t i, const Signatures& rows, MethodResults& method) {
    const bool whole = is_whole(i);
    const StreamedRows streamed = whole ? StreamedRows{} : streamed_rows(i, rows);
    std::optional<MatrixFile> file;
    if (configuration_->keep_distances && !distance_files_->empty())
      file.emplace((*distance_files_)[i], labels_.size());
    std::optional<OverviewAccumulator> overview;
    if (configuration_->report.enabled) {
      const double largest = whole ? largest_of_whole(whole_[i], holders_[i].indices().front())
                                   : largest_distance_from_first(streamed.distance, streamed.rows);
      overview = begin_overview(labels_, largest);
    }
    RowVisitor also;
    if (file || overview) {
      also = [&](Eigen::Index first, const DistanceTable& some) {
        if (overview) accumulate(some, first, *overview);
        if (file) file->add(some);
      };
    }
    double seconds = 0;
    std::vector<RowScores> scores;
    if (whole) {
      scores.push_back(scores_of_whole(whole_[i], also, seconds));
    } else {
      for (const RowRange& some : entries()) scores.push_back(scores_of(streamed, some, also, seconds));
    }
    if (file) file->close();
    method.evaluations = evaluations_of(task_, evaluations_, scores);
    if (overview) method.overview = overview_of(std::move(*overview));
    DistanceMatrix matrix = std::move(whole_[i]);
    if (keeps_matrices()) method.distances = std::move(matrix);
    return seconds;
  }

  static double largest_of_whole(const DistanceMatrix& distances, Eigen::Index row) {
    return largest_finite({distances.row(row).data(), static_cast<std::size_t>(distances.cols())}, row);
  }

  const Configuration* configuration_;
  const std::vector<fs::path>* distance_files_;
  const RunContext* context_;
  std::vector<int> labels_;
  RetrievalTask task_;
  std::vector<EvaluationOptions> evaluations_;  ///< by protocol
  std::vector<bool> in_derived_;                ///< per signature
  std::vector<DistanceMatrix> whole_;           ///< per signature
  std::vector<std::string> remarks_;            ///< per signature
  std::vector<ModelsWithSignature> holders_;    ///< per signature
};

}  // namespace

void check_queries(const std::vector<Model>& models, const EvaluationOptions& options) {
  static_cast<void>(RowEvaluator(leave_one_out(labels_of(models)), options, 0, 0));
}

void run_methods(const Configuration& configuration, const std::vector<fs::path>& distance_files,
                 const RunContext& context, ComputedSignatures& computed, ExperimentResults& results) {
  MethodsRun(configuration, distance_files, context, results.models, computed.without).run(computed, results);
}

bool has_streamed_methods(const Configuration& configuration, std::size_t models) {
  return std::ranges::any_of(taking_part_in_derived(configuration.signatures),
                             [&](bool in_derived) { return !is_in_memory(in_derived, models); });
}

std::size_t evaluate_part_of_rows(const Configuration& configuration, const RunContext& context,
                                  const std::vector<Model>& models, const ComputedSignatures& computed,
                                  const Part& part) {
  return MethodsRun(configuration, {}, context, models, computed.without).run_part(computed, part);
}

}  // namespace shapegauge
