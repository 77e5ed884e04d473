// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/multi_dataset_results.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/metrics/equal_scores.h"

namespace shapegauge {

namespace {

using MultiDatasetJson = nlohmann::ordered_json;

// Averages of a method, by measure.
Eigen::VectorXd averages_of_method(const MethodScores& scores, Average average) {
  const UnitValues units =
      unit_values_of(scores.values, class_numbers(scores.classes), ResamplingUnit::queries, average);
  Eigen::VectorXd averages(units.values.cols());
  for (Eigen::Index k = 0; k < averages.size(); ++k) {
    averages[k] = averages_of({.values = units.values.col(k), .weights = units.weights})[0];
  }
  return averages;
}

// The scores of one protocol, by method.
std::vector<const MethodScores*> scores_under(const EvaluatedDataset& dataset, const std::string& protocol) {
  std::vector<const MethodScores*> scores;
  for (const MethodScores& one : dataset.scores) {
    if (one.protocol == protocol) scores.push_back(&one);
  }
  return scores;
}

// Standard deviations over repetitions, data sets x methods, of results under a single protocol.
Eigen::MatrixXd deviations_of(std::span<const EvaluatedDataset> datasets, Average average, Eigen::Index measure) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (datasets.front().micro_deviations.empty()) return {};
  Eigen::MatrixXd deviations(std::ssize(datasets), std::ssize(datasets.front().scores));
  for (Eigen::Index set = 0; set < deviations.rows(); ++set) {
    const EvaluatedDataset& dataset = datasets[static_cast<std::size_t>(set)];
    const auto& by_method = average == Average::micro ? dataset.micro_deviations : dataset.macro_deviations;
    for (Eigen::Index method = 0; method < deviations.cols(); ++method) {
      const Eigen::VectorXd& by_measure = by_method[static_cast<std::size_t>(method)];
      deviations(set, method) = by_measure.size() == 0 ? none : by_measure[measure];
    }
  }
  return deviations.array().isNaN().all() ? Eigen::MatrixXd() : deviations;
}

std::vector<std::string> protocols_of(const EvaluatedDataset& dataset) {
  std::vector<std::string> protocols;
  for (const MethodScores& one : dataset.scores) {
    if (std::ranges::find(protocols, one.protocol) == protocols.end()) protocols.push_back(one.protocol);
  }
  return protocols;
}

// Tables of all measures, without ranks.
std::vector<MultiDatasetTable> tables_of_measures(std::span<const EvaluatedDataset> datasets,
                                                  const std::string& protocol, Average average) {
  const std::vector<const MethodScores*> first = scores_under(datasets.front(), protocol);
  std::vector<MultiDatasetTable> tables;
  for (const std::string& measure : first.front()->measures) {
    tables.push_back({.protocol = protocol,
                      .average = average,
                      .measure = measure,
                      .values = Eigen::MatrixXd(std::ssize(datasets), std::ssize(first)),
                      .deviations = deviations_of(datasets, average, std::ssize(tables)),
                      .ranks = {}});
  }
  for (std::size_t set = 0; set < datasets.size(); ++set) {
    const std::vector<const MethodScores*> scores = scores_under(datasets[set], protocol);
    for (std::size_t method = 0; method < scores.size(); ++method) {
      const Eigen::VectorXd averages = averages_of_method(*scores[method], average);
      for (std::size_t k = 0; k < tables.size(); ++k) {
        tables[k].values(static_cast<Eigen::Index>(set), static_cast<Eigen::Index>(method)) =
            averages[static_cast<Eigen::Index>(k)];
      }
    }
  }
  return tables;
}

MultiDatasetJson finite_or_null(double number) {
  return std::isfinite(number) ? MultiDatasetJson(number) : MultiDatasetJson(nullptr);
}

std::vector<std::string> summary_row(const MultiDatasetTable& table, std::size_t position,
                                     const std::vector<std::string>& letters, const ScoreStyle& style) {
  const auto method = static_cast<Eigen::Index>(table.ranks.order[position]);
  std::vector<std::string> row;
  for (Eigen::Index set = 0; set < table.values.rows(); ++set) {
    row.push_back(score_text(table.values(set, method), style));
    if (table.deviations.size() == 0 || std::isnan(table.deviations(set, method))) continue;
    row.back() += " ± " + score_text(table.deviations(set, method), style);
  }
  row.push_back(score_text(table.values.col(method).mean(), style));
  row.push_back(decimal_text(table.ranks.mean_ranks[method], 2));
  if (!table.rank_intervals.empty()) {
    const auto& [best, worst] = table.rank_intervals[table.ranks.order[position]];
    row.push_back(best == worst ? fmt::format("{}", best) : fmt::format("{}-{}", best, worst));
  }
  row.push_back(letters[position]);
  return row;
}

MultiDatasetJson pairs_json(const MultiDatasetResults& results, const RankComparison& ranks) {
  MultiDatasetJson pairs = MultiDatasetJson::array();
  for (const RankDifference& pair : ranks.pairs) {
    pairs.push_back({{"first", results.methods[pair.first]},
                     {"second", results.methods[pair.second]},
                     {"difference_of_mean_ranks", pair.mean_ranks},
                     {"p", pair.p},
                     {"wins", pair.data_sets.wins},
                     {"ties", pair.data_sets.ties},
                     {"losses", pair.data_sets.losses}});
  }
  return pairs;
}

MultiDatasetJson table_json(const MultiDatasetResults& results, const MultiDatasetTable& table) {
  const std::vector<std::string> letters = letters_of(table.ranks);
  MultiDatasetJson methods = MultiDatasetJson::array();
  for (std::size_t position = 0; position < letters.size(); ++position) {
    const auto method = static_cast<Eigen::Index>(table.ranks.order[position]);
    MultiDatasetJson values = MultiDatasetJson::object();
    MultiDatasetJson deviations = MultiDatasetJson::object();
    for (std::size_t set = 0; set < results.datasets.size(); ++set) {
      const auto row = static_cast<Eigen::Index>(set);
      values[results.datasets[set].name] = table.values(row, method);
      if (table.deviations.size() == 0 || std::isnan(table.deviations(row, method))) continue;
      deviations[results.datasets[set].name] = table.deviations(row, method);
    }
    methods.push_back({{"method", results.methods[table.ranks.order[position]]},
                       {"values", values},
                       {"mean_rank", table.ranks.mean_ranks[method]},
                       {"group", letters[position]}});
    if (!deviations.empty()) methods.back()["deviations"] = std::move(deviations);
    if (table.rank_intervals.empty()) continue;
    const auto& [best, worst] = table.rank_intervals[table.ranks.order[position]];
    methods.back()["rank_interval"] = {best, worst};
  }
  const FriedmanTest& friedman = table.ranks.friedman;
  return {{"protocol", table.protocol},
          {"average", name_of(table.average)},
          {"measure", table.measure},
          {"friedman",
           {{"chi_squared", friedman.chi_squared},
            {"tie_correction", friedman.tie_correction},
            {"p", friedman.p},
            {"f", finite_or_null(friedman.f)},
            {"f_p", friedman.f_p}}},
          {"critical_difference", finite_or_null(table.ranks.critical_difference)},
          {"methods", std::move(methods)},
          {"pairs", pairs_json(results, table.ranks)}};
}

}  // namespace

std::vector<MultiDatasetTable> multi_dataset_tables(std::span<const EvaluatedDataset> datasets, double alpha,
                                                    const std::optional<ResamplingOptions>& intervals) {
  std::vector<MultiDatasetTable> tables;
  for (const std::string& protocol : protocols_of(datasets.front())) {
    for (const Average average : {Average::micro, Average::macro}) {
      for (MultiDatasetTable& table : tables_of_measures(datasets, protocol, average)) {
        table.ranks = compare_by_ranks(table.values, alpha);
        if (intervals && datasets.size() > 1) {
          table.rank_intervals = rank_intervals(table.ranks.ranks, 1 - alpha, *intervals);
        }
        tables.push_back(std::move(table));
      }
    }
  }
  return tables;
}

const MultiDatasetTable& main_table(const MultiDatasetResults& results) {
  return *std::ranges::find(results.tables, results.main_measure, &MultiDatasetTable::measure);
}

TextTable multi_dataset_summary(const MultiDatasetResults& results, const MultiDatasetTable& table,
                                const ScoreStyle& style) {
  TextTable summary{.header = {"method"}, .rows = {}, .text_columns = 1};
  for (const EvaluatedDataset& dataset : results.datasets) summary.header.push_back(dataset.name);
  summary.header.insert(summary.header.end(), {"mean", "mean rank"});
  if (!table.rank_intervals.empty()) summary.header.emplace_back("rank");
  summary.header.emplace_back("group");
  const std::vector<std::string> letters = letters_of(table.ranks);
  for (std::size_t position = 0; position < letters.size(); ++position) {
    std::vector<std::string> row = summary_row(table, position, letters, style);
    row.insert(row.begin(), results.methods[table.ranks.order[position]]);
    summary.rows.push_back(std::move(row));
  }
  if (results.methods.size() < 2) return summary;
  for (std::size_t set = 0; set < results.datasets.size(); ++set) {
    const double best = table.values.row(static_cast<Eigen::Index>(set)).maxCoeff();
    for (std::size_t row = 0; row < summary.rows.size(); ++row) {
      const auto method = static_cast<Eigen::Index>(table.ranks.order[row]);
      if (!are_equal_scores(table.values(static_cast<Eigen::Index>(set), method), best)) continue;
      summary.emphases.push_back({.row = row, .column = 1 + set, .bold = true, .mark = {}});
    }
  }
  return summary;
}

TextTable multi_dataset_csv_table(const MultiDatasetResults& results, const ScoreStyle& style) {
  TextTable all{.header = {"protocol", "average", "measure"}, .rows = {}, .text_columns = 4};
  const bool repeated =
      std::ranges::any_of(results.tables, [](const auto& table) { return table.deviations.size() > 0; });
  for (const MultiDatasetTable& table : results.tables) {
    MultiDatasetTable without = table;
    without.deviations.resize(0, 0);
    const TextTable one = multi_dataset_summary(results, without, style);
    if (all.rows.empty()) {
      all.header.insert(all.header.end(), one.header.begin(), one.header.end());
      for (const EvaluatedDataset& dataset : results.datasets) {
        if (repeated) all.header.push_back(dataset.name + "_deviation");
      }
    }
    for (std::size_t position = 0; position < one.rows.size(); ++position) {
      std::vector<std::string> row = one.rows[position];
      row.insert(row.begin(), {table.protocol, name_of(table.average), table.measure});
      for (Eigen::Index set = 0; set < table.deviations.rows(); ++set) {
        const double deviation = table.deviations(set, static_cast<Eigen::Index>(table.ranks.order[position]));
        row.push_back(std::isnan(deviation) ? "" : score_text(deviation, style));
      }
      row.resize(all.header.size());
      all.rows.push_back(std::move(row));
    }
  }
  return all;
}

TextTable multi_dataset_pairs_table(const MultiDatasetResults& results) {
  TextTable all{.header = {"protocol", "average", "measure", "first", "second", "difference_of_mean_ranks", "p", "wins",
                           "ties", "losses"},
                .text_columns = 5};
  for (const MultiDatasetTable& table : results.tables) {
    for (const RankDifference& pair : table.ranks.pairs) {
      all.rows.push_back({table.protocol, name_of(table.average), table.measure, results.methods[pair.first],
                          results.methods[pair.second], decimal_text(pair.mean_ranks, 4), fmt::format("{:.6g}", pair.p),
                          fmt::format("{}", pair.data_sets.wins), fmt::format("{}", pair.data_sets.ties),
                          fmt::format("{}", pair.data_sets.losses)});
    }
  }
  return all;
}

MultiDatasetJson multi_dataset_json(const MultiDatasetResults& results) {
  MultiDatasetJson datasets = MultiDatasetJson::array();
  for (const EvaluatedDataset& dataset : results.datasets) {
    datasets.push_back({{"name", dataset.name}, {"folder", dataset.folder}, {"models", dataset.models}});
  }
  MultiDatasetJson failures = MultiDatasetJson::array();
  for (const auto& [name, reason] : results.failures) failures.push_back({{"name", name}, {"reason", reason}});
  MultiDatasetJson tables = MultiDatasetJson::array();
  for (const MultiDatasetTable& table : results.tables) tables.push_back(table_json(results, table));
  return {{"version", version()},
          {"name", results.name},
          {"methods", results.methods},
          {"datasets", std::move(datasets)},
          {"failed_datasets", std::move(failures)},
          {"alpha", results.alpha},
          {"tables", std::move(tables)}};
}

std::string test_words(const MultiDatasetResults& results, const MultiDatasetTable& table) {
  if (results.methods.size() < 2 || results.datasets.size() < 2) return "Too few methods or data sets for tests.";
  const FriedmanTest& friedman = table.ranks.friedman;
  std::string words = fmt::format(
      "Friedman's test: chi-squared {:.2f}, p {:.3g}; Iman and Davenport: F {:.2f}, p {:.3g}. Nemenyi's critical "
      "difference of mean ranks at {:g}: {:.2f}.",
      friedman.chi_squared, friedman.p, friedman.f, friedman.f_p, results.alpha, table.ranks.critical_difference);
  constexpr std::size_t few_sets = 10;
  if (results.datasets.size() <= few_sets) {
    words += fmt::format(" With {} data sets the tests are approximate and find large differences only.",
                         results.datasets.size());
  }
  return words;
}

std::string multi_dataset_html(const MultiDatasetResults& results) {
  MultiDatasetPage page{.title = results.name,
                        .description = results.description,
                        .methods = results.methods,
                        .datasets = {},
                        .tables = results.tables,
                        .words = {},
                        .main_measure = results.main_measure,
                        .failures = results.failures};
  for (const EvaluatedDataset& dataset : results.datasets) {
    page.datasets.push_back({.name = dataset.name,
                             .page = dataset.page,
                             .models = dataset.models,
                             .queries = dataset.scores.front().queries.size()});
  }
  for (const MultiDatasetTable& table : results.tables) page.words.push_back(test_words(results, table));
  return multi_dataset_page(page);
}

}  // namespace shapegauge
