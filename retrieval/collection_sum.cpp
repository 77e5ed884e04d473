#include "shapegauge/retrieval/collection_sum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

namespace {

/// Results of one pass over the distances of a term.
struct TermPass {
  NearestModels nearest;
  Eigen::VectorXd means;  ///< mean_distance_to_nearest(), by model
};

TermPass pass_over(Eigen::Index models, const RowSource& rows) {
  TermPass found;
  found.means.resize(models);
  const RowSource measured = [&](Eigen::Index first, Eigen::Index count) {
    DistanceMatrix block = rows(first, count);
    parallel_for(Eigen::Index{0}, block.rows(), [&](Eigen::Index i) {
      found.means[first + i] =
          mean_distance_to_nearest({block.row(i).data(), static_cast<std::size_t>(block.cols())}, first + i);
    });
    return block;
  };
  found.nearest = nearest_models(models, nearest_for_weights(), measured);
  return found;
}

/// Pass over the rows of a few models; the entries of the others follow from an earlier pass and these rows.
class PassUpdate {
 public:
  PassUpdate(Eigen::Index models, const RowSource& rows, const EarlierSum& earlier, std::size_t term)
      : models_(models),
        rows_(rows),
        earlier_(earlier),
        before_(earlier.sum.nearest[term]),
        count_(std::clamp<Eigen::Index>(models - 1, 0, nearest_for_weights())),
        now_of_(static_cast<std::size_t>(before_.indices.rows()), -1) {
    found_.nearest.indices.resize(models, count_);
    found_.nearest.distances.resize(models, count_);
    found_.means.resize(models);
    for (std::size_t i = 0; i < earlier.places.size(); ++i) {
      if (earlier.places[i] >= 0) now_of_[static_cast<std::size_t>(earlier.places[i])] = static_cast<std::int32_t>(i);
    }
  }

  TermPass run() {
    for (Eigen::Index i = 0; i < models_; ++i) {
      if (place_of(i) >= 0) continue;
      new_models_.push_back(static_cast<std::int32_t>(i));
      new_rows_.push_back(whole_row(i));
    }
    for (Eigen::Index i = 0; i < models_; ++i) {
      if (place_of(i) >= 0 && !follows_from_earlier(i)) whole_row(i);
    }
    return std::move(found_);
  }

 private:
  using Entry = std::pair<double, std::int32_t>;

  [[nodiscard]] Eigen::Index place_of(Eigen::Index model) const {
    return earlier_.places[static_cast<std::size_t>(model)];
  }

  /// Keeps the first of the entries, which must include all of the nearest.
  void take_nearest(Eigen::Index model, std::vector<Entry>& entries) {
    std::ranges::partial_sort(entries, entries.begin() + count_);
    for (Eigen::Index n = 0; n < count_; ++n) {
      const auto& [distance, other] = entries[static_cast<std::size_t>(n)];
      found_.nearest.indices(model, n) = std::isfinite(distance) ? other : -1;
      found_.nearest.distances(model, n) = distance;
    }
  }

  /// Requests the model's row and computes its nearest models and their mean distance.
  DistanceMatrix whole_row(Eigen::Index model) {
    DistanceMatrix row = rows_(model, 1);
    std::vector<Entry> entries;
    for (Eigen::Index j = 0; j < models_; ++j) {
      if (j != model) entries.emplace_back(row(0, j), static_cast<std::int32_t>(j));
    }
    take_nearest(model, entries);
    found_.means[model] = mean_distance_to_nearest({row.data(), static_cast<std::size_t>(row.size())}, model);
    return row;
  }

  /// Computes the model's nearest models and their mean distance from its earlier nearest and the new models. Returns
  /// false if these do not suffice.
  bool follows_from_earlier(Eigen::Index model) {
    std::vector<Entry> entries;
    for (Eigen::Index n = 0; n < before_.indices.cols(); ++n) {
      const std::int32_t other = before_.indices(place_of(model), n);
      if (other < 0 || now_of_[static_cast<std::size_t>(other)] < 0) return false;
      entries.emplace_back(before_.distances(place_of(model), n), now_of_[static_cast<std::size_t>(other)]);
    }
    for (std::size_t k = 0; k < new_models_.size(); ++k) entries.emplace_back(new_rows_[k](0, model), new_models_[k]);
    if (std::ssize(entries) < count_) return false;
    take_nearest(model, entries);
    constexpr std::ptrdiff_t averaged = 10;  // number of models averaged by mean_distance_to_nearest()
    const auto distances = found_.nearest.distances.row(model);
    if (count_ < models_ - 1 && (distances.array() > 0).count() < averaged) return false;
    found_.means[model] = mean_distance_to_nearest({distances.data(), static_cast<std::size_t>(count_)});
    return true;
  }

  Eigen::Index models_;
  const RowSource& rows_;
  const EarlierSum& earlier_;
  const NearestModels& before_;
  Eigen::Index count_;
  std::vector<std::int32_t> now_of_;  ///< by earlier model: present index; -1 if removed
  std::vector<std::int32_t> new_models_;
  std::vector<DistanceMatrix> new_rows_;
  TermPass found_;
};

double unit_of(Eigen::Index models, const RowSource& rows, DistanceScale scale, std::size_t term) {
  if (scale == DistanceScale::none) return 1;
  const double unit = distance_unit(rows(0, models), scale);
  if (unit > 0) return unit;
  throw ArgumentError("the median or mean of the distances of term " + std::to_string(term) +
                      " (counted from 0) is 0: it cannot be divided by it");
}

}  // namespace

CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale, const EarlierSum* earlier) {
  check_sum_weights(terms.size(), weights);
  CollectionSum sum;
  sum.scale = scale;
  sum.weights.assign(weights.begin(), weights.end());
  const bool local = is_local(scale);
  sum.nearest.resize(terms.size());
  sum.means.resize(terms.size());
  if (local) sum.local_scales.resize(terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    sum.units.push_back(local || weights[k] == 0 ? 1 : unit_of(models, terms[k], scale, k));
    if (weights[k] == 0 || (!local && kind == SumWeights::given)) continue;
    const bool known = earlier != nullptr && earlier->unchanged[k] && earlier->sum.nearest[k].indices.rows() > 0;
    TermPass found = known ? PassUpdate(models, terms[k], *earlier, k).run() : pass_over(models, terms[k]);
    found.nearest.largest = 0;  // unknown after an update, and unused here
    sum.nearest[k] = std::move(found.nearest);
    sum.means[k] = std::move(found.means);
    if (local) sum.local_scales[k] = LocalScales::of_means(sum.means[k]);
    if (scale == DistanceScale::local_spread) {
      sum.units[k] = spread_of_scaled(sum.means[k], sum.local_scales[k], terms[k]);
    }
  }
  if (kind == SumWeights::agreement) sum.weights = sum_weights(sum.nearest, weights);
  return sum;
}

Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(distances.front().size());
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const double weight = sum.weights[k];
    if (weight == 0) continue;
    if (!is_local(sum.scale)) {
      row += weight / sum.units[k] * distances[k];
      continue;
    }
    const LocalScales& scales = sum.local_scales[k];
    const double root = member >= 0 ? scales.roots[member]
                                    : scales.root_of(mean_distance_to_nearest(
                                          {distances[k].data(), static_cast<std::size_t>(distances[k].size())}));
    row.array() += weight / sum.units[k] * (distances[k].array() / (root * scales.roots.array()));
  }
  return row.cwiseMin(std::numeric_limits<double>::max());
}

}  // namespace shapegauge
