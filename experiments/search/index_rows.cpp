// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/search/index_rows.h"

#include <cstddef>
#include <optional>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

namespace {

/// Maximum number of models whose distances by a term are kept in memory, which takes half the time.
constexpr std::size_t max_in_memory = 10'000;

/// Distances between all models by one term.
class TermDistances {
 public:
  TermDistances(const SearchMethod& method, std::size_t term, const IndexTable& table, bool in_memory)
      : distance_(distances_of(method)[term]), table_(table.signatures()) {
    check_signatures({table_, 0}, distance_);
    if (in_memory) whole_ = distance_matrix(table_, distance_);
  }

  [[nodiscard]] DistanceMatrix rows(Eigen::Index first, Eigen::Index count) const {
    if (whole_.size() > 0) return whole_.middleRows(first, count);
    return distances_between(distance_, {table_.middleRows(first, count), first}, {table_, 0});
  }

 private:
  NamedDistance distance_;
  Eigen::Map<const Signatures> table_;
  DistanceMatrix whole_;  ///< or empty
};

}  // namespace

std::vector<NamedDistance> distances_of(const SearchMethod& method) {
  std::vector<NamedDistance> distances;
  for (const std::size_t term : method.terms) {
    distances.push_back(distance_between(method.configuration.signatures[term], method.configuration));
  }
  return distances;
}

CollectionSum sum_of(const SearchMethod& method, const ShapeIndex& index, const RunControl& control) {
  const std::size_t models = index.models.size();
  const bool in_memory = models <= max_in_memory;
  std::optional<TermDistances> now;  // one at a time
  std::size_t term = method.terms.size();
  std::vector<RowSource> terms;
  for (std::size_t k = 0; k < method.terms.size(); ++k) {
    terms.emplace_back([&, k](Eigen::Index first, Eigen::Index count) {
      if (control.interrupted()) throw Interrupted();
      if (term != k) {
        term = k;
        control.progress("distances", k, method.terms.size());
        now.reset();
        now.emplace(method, k, index.tables[k], in_memory);
      }
      return now->rows(first, count);
    });
  }
  const auto& [weights, options] = method.sum;
  return collection_sum(static_cast<Eigen::Index>(models), terms, weights, options.weights, options.scale);
}

std::vector<Eigen::VectorXd> term_distances(const std::vector<NamedDistance>& distances, const ShapeIndex& index,
                                            std::span<const Eigen::RowVectorXf> signatures, Eigen::Index member) {
  std::vector<Eigen::VectorXd> found;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const Signatures row = signatures[k];
    const Eigen::Index models = index.tables[k].rows;
    // A query from elsewhere gets an index after all models.
    const SignatureBlock some{row, member >= 0 ? member : models};
    check_signatures(some, distances[k]);
    found.emplace_back(distances_between(distances[k], some, {index.tables[k].signatures(), 0}).row(0));
  }
  return found;
}

NearestModels nearest_models_in_index(const SearchMethod& method, const ShapeIndex& index, int count,
                                      const RunControl& control) {
  std::vector<TermDistances> terms;
  for (std::size_t k = 0; k < method.terms.size(); ++k) {
    control.progress("neighbours", k, 2 * method.terms.size());
    const bool in_memory = index.models.size() * method.terms.size() <= max_in_memory;
    terms.emplace_back(method, k, index.tables[k], in_memory);
  }
  const auto models = std::ssize(index.models);
  const RowSource rows = [&](Eigen::Index first, Eigen::Index some) {
    if (control.interrupted()) throw Interrupted();
    control.progress("neighbours", index.models.size() + static_cast<std::size_t>(first), 2 * index.models.size());
    std::vector<DistanceMatrix> blocks;
    for (const TermDistances& term : terms) blocks.push_back(term.rows(first, some));
    DistanceMatrix sums(some, models);
    parallel_for(Eigen::Index{0}, some, [&](Eigen::Index i) {
      std::vector<Eigen::VectorXd> of_terms;
      for (const DistanceMatrix& block : blocks) of_terms.emplace_back(block.row(i));
      sums.row(i) = sum_row(index.sum, of_terms, first + i).transpose();
    });
    return sums;
  };
  return nearest_models(models, count, rows);
}

}  // namespace shapegauge
