// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/search/search.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <system_error>
#include <utility>

#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/search/index_rows.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Signatures of a query, one a term, and the model that it equals, if any.
struct DescribedQuery {
  std::vector<Eigen::RowVectorXf> signatures;
  std::optional<std::size_t> member;
};

/// Returns a key that identifies the contents of a shape file.
std::string contents_key(const std::string& sha256, const fs::path& file) {
  return sha256 + lower_case(file.extension().string());
}

/// Returns the models by contents.
std::multimap<std::string, std::size_t> models_by_contents(const ShapeIndex& index) {
  std::multimap<std::string, std::size_t> models;
  for (std::size_t i = 0; i < index.models.size(); ++i) {
    models.emplace(contents_key(index.models[i].sha256, index.models[i].path), i);
  }
  return models;
}

/// Describes a shape that is not in a file.
ModelDescription description_of(const Shape& shape, const Configuration& configuration, std::span<const Field> fields) {
  Cache none;
  CachedShape bench(
      "", [&] { return PerturbedShape{.shape = shape, .chosen = {}}; }, configuration.preparation, true, none);
  return describe_shape(bench, configuration, fields, {});
}

/// Describes queries like the models of an index.
class QueryDescriber {
 public:
  QueryDescriber(const OpenIndex& index, Cache& cache)
      : index_(&index),
        cache_(&cache),
        by_contents_(models_by_contents(index.contents)),
        configuration_(index.method.configuration),
        fields_(distinct_fields(configuration_.signatures)) {
    configuration_.on_error = OnError::stop;  // a query needs all signatures
  }

  [[nodiscard]] DescribedQuery described(const SearchQuery& query, bool alone) const {
    if (query.shape) return from(description_of(*query.shape, configuration_, fields_));
    const auto [first, last] = by_contents_.equal_range(contents_key(sha256_of_file(query.file), query.file));
    if (first != last) {
      const auto itself =
          std::find_if(first, last, [&](const auto& one) { return is_file_of(one.second, query.file); });
      if (itself == last) return {.signatures = rows_of_model(first->second), .member = {}};
      return {.signatures = rows_of_model(itself->second), .member = itself->second};
    }
    const Dataset one{.models = {{.id = query.name, .file = query.file, .label = 0}}, .classes = {"query"}};
    return from(describe_model(one, 0, configuration_, fields_, alone, *cache_));
  }

 private:
  [[nodiscard]] bool is_file_of(std::size_t model, const fs::path& file) const {
    std::error_code gone;
    return fs::equivalent(index_->collection.file(index_->contents.models[model].path), file, gone) && !gone;
  }

  [[nodiscard]] std::vector<Eigen::RowVectorXf> rows_of_model(std::size_t model) const {
    std::vector<Eigen::RowVectorXf> rows;
    for (const IndexTable& table : index_->contents.tables) {
      rows.emplace_back(table.signatures().row(static_cast<Eigen::Index>(model)));
    }
    return rows;
  }

  [[nodiscard]] DescribedQuery from(ModelDescription description) const {
    static const Shape none;
    for (std::size_t i = 0; i < configuration_.signatures.size(); ++i) {
      const std::optional<DescriptorChoice>& choice = configuration_.signatures[i].descriptor;
      if (!choice || !needs_learning(*choice)) continue;
      std::vector<ScalarField> fields;
      for (const Field& field : choice->fields) {
        fields.push_back(to_scalar_field(description.fields[index_of(fields_, field)]));
      }
      description.features[i] =
          describe_features(*choice, {.shape = none, .fields = fields}, index_->contents.learnt[i]);
    }
    const std::vector<Signatures> tables =
        assemble_signatures({&description}, fields_, configuration_.signatures, index_->contents.field_ranges);
    DescribedQuery query;
    for (const std::size_t term : index_->method.terms) query.signatures.emplace_back(tables[term].row(0));
    return query;
  }

  const OpenIndex* index_;
  Cache* cache_;
  std::multimap<std::string, std::size_t> by_contents_;
  Configuration configuration_;
  std::vector<Field> fields_;
};

std::vector<RankedModel> nearest_by(const Eigen::VectorXd& distances, std::optional<std::size_t> without,
                                    std::size_t count) {
  std::vector<RankedModel> models;
  for (Eigen::Index j = 0; j < distances.size(); ++j) {
    if (!without || std::cmp_not_equal(*without, j)) models.push_back({.model = j, .distance = distances[j]});
  }
  count = std::min(count, models.size());
  std::ranges::partial_sort(models, models.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [](const RankedModel& one) { return std::pair(one.distance, one.model); });
  models.resize(count);
  return models;
}

/// Returns the number of neighbours of each model needed by diffusion.
int neighbours_for(const SearchMethod& method) { return neighbour_counts(method.diffusion.neighbours).back(); }

/// Computes the neighbours of all models once.
void require_neighbours(OpenIndex& index, const RunControl& control, std::vector<std::string>& notes) {
  const int count = neighbours_for(index.method);
  const auto models = std::ssize(index.contents.models);
  const auto needed = std::min<Eigen::Index>(count, models - 1);
  if (index.contents.nearest.indices.rows() == models && index.contents.nearest.indices.cols() == needed) return;
  index.contents.nearest = nearest_models_in_index(index.method, index.contents, count, control);
  write_index(index, notes);
}

/// Returns the nearest models after diffusion over the collection and, if it is not a member, the query.
std::vector<RankedModel> reranked(const OpenIndex& index, const Eigen::VectorXd& distances,
                                  std::optional<std::size_t> member, std::size_t count) {
  const NearestModels& nearest = index.contents.nearest;
  if (member) {
    return diffused_nearest(nearest, static_cast<Eigen::Index>(*member), distances, index.method.diffusion, count);
  }
  Eigen::VectorXd with_itself(distances.size() + 1);
  with_itself << distances, 0;
  return diffused_nearest(append_query(nearest, distances, neighbours_for(index.method)), distances.size(), with_itself,
                          index.method.diffusion, count);
}

double median_of(const Eigen::VectorXd& distances) {
  std::vector<double> sorted(distances.begin(), distances.end());
  const auto middle = sorted.begin() + std::ssize(sorted) / 2;
  std::ranges::nth_element(sorted, middle);
  return *middle;
}

std::vector<SearchAnswer> answers(OpenIndex& index, std::span<const SearchQuery> queries, const SearchOptions& options,
                                  const RunControl& control, Cache& cache, std::vector<std::string>& notes) {
  if (options.rerank) require_neighbours(index, control, notes);
  const QueryDescriber describer(index, cache);
  const std::vector<NamedDistance> distances = distances_of(index.method);
  std::vector<SearchAnswer> found(queries.size());
  std::vector<std::size_t> all(queries.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<ModelFailure> failures = for_each_model(all, "queries", false, control, [&](std::size_t i) {
    found[i].query = queries[i].name;
    const DescribedQuery query = describer.described(queries[i], queries.size() == 1);
    found[i].member = query.member;
    const auto member = query.member ? static_cast<Eigen::Index>(*query.member) : Eigen::Index{-1};
    const Eigen::VectorXd row =
        sum_row(index.contents.sum, term_distances(distances, index.contents, query.signatures, member), member);
    if (!options.rerank) found[i].median = median_of(row);
    found[i].nearest = options.rerank ? reranked(index, row, query.member, options.count)
                                      : nearest_by(row, query.member, options.count);
  });
  for (const ModelFailure& failure : failures) {
    found[failure.model].query = queries[failure.model].name;
    found[failure.model].failure = failure.message;
  }
  return found;
}

}  // namespace

std::vector<SearchAnswer> search(OpenIndex& index, std::span<const SearchQuery> queries, const SearchOptions& options,
                                 const RunControl& control, Cache& cache, std::vector<std::string>& notes) {
  std::vector<SearchAnswer> found;
  with_threads(control, [&] { found = answers(index, queries, options, control, cache, notes); });
  return found;
}

}  // namespace shapegauge
