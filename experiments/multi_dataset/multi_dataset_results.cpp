#include "shapegauge/experiments/multi_dataset/multi_dataset_results.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/equal_scores.h"
#include "shapegauge/pages/multi_dataset_page.h"

namespace shapegauge {

namespace {

using MultiDatasetJson = nlohmann::ordered_json;

// The classes of queries as numbers in the order in which they come.
std::vector<int> class_numbers(const std::vector<std::string>& classes) {
  std::vector<std::string> known;
  std::vector<int> numbers;
  for (const std::string& name : classes) {
    const auto found = std::ranges::find(known, name);
    numbers.push_back(static_cast<int>(found - known.begin()));
    if (found == known.end()) known.push_back(name);
  }
  return numbers;
}

double average_of(const MethodScores& scores, Eigen::Index measure, Average average) {
  return averages_of(
      units_of(scores.values.col(measure), class_numbers(scores.classes), ResamplingUnit::queries, average))[0];
}

// The scores of one protocol, by method.
std::vector<const MethodScores*> scores_under(const EvaluatedDataset& dataset, const std::string& protocol) {
  std::vector<const MethodScores*> scores;
  for (const MethodScores& one : dataset.scores) {
    if (one.protocol == protocol) scores.push_back(&one);
  }
  return scores;
}

std::vector<std::string> protocols_of(const EvaluatedDataset& dataset) {
  std::vector<std::string> protocols;
  for (const MethodScores& one : dataset.scores) {
    if (std::ranges::find(protocols, one.protocol) == protocols.end()) protocols.push_back(one.protocol);
  }
  return protocols;
}

MultiDatasetJson finite_or_null(double number) {
  return std::isfinite(number) ? MultiDatasetJson(number) : MultiDatasetJson(nullptr);
}

std::vector<std::string> summary_row(const MultiDatasetTable& table, std::size_t position,
                                     const std::vector<std::string>& letters, int decimals) {
  const auto method = static_cast<Eigen::Index>(table.ranks.order[position]);
  std::vector<std::string> row;
  for (Eigen::Index set = 0; set < table.values.rows(); ++set) {
    row.push_back(decimal_text(100 * table.values(set, method), decimals));
  }
  row.push_back(decimal_text(100 * table.values.col(method).mean(), decimals));
  row.push_back(decimal_text(table.ranks.mean_ranks[method], 2));
  row.push_back(letters[position]);
  return row;
}

std::vector<std::string> letters_of(const RankComparison& ranks) {
  return compact_letters(ranks.order.size(), ranks.groups);
}

MultiDatasetJson table_json(const MultiDatasetResults& results, const MultiDatasetTable& table) {
  const std::vector<std::string> letters = letters_of(table.ranks);
  MultiDatasetJson methods = MultiDatasetJson::array();
  for (std::size_t position = 0; position < letters.size(); ++position) {
    const auto method = static_cast<Eigen::Index>(table.ranks.order[position]);
    MultiDatasetJson values = MultiDatasetJson::object();
    for (std::size_t set = 0; set < results.datasets.size(); ++set) {
      values[results.datasets[set].name] = table.values(static_cast<Eigen::Index>(set), method);
    }
    methods.push_back({{"method", results.methods[table.ranks.order[position]]},
                       {"values", values},
                       {"mean_rank", table.ranks.mean_ranks[method]},
                       {"group", letters[position]}});
  }
  MultiDatasetJson pairs = MultiDatasetJson::array();
  for (const RankDifference& pair : table.ranks.pairs) {
    pairs.push_back({{"first", results.methods[pair.first]},
                     {"second", results.methods[pair.second]},
                     {"difference_of_mean_ranks", pair.mean_ranks},
                     {"p", pair.p},
                     {"wins", pair.data_sets.wins},
                     {"ties", pair.data_sets.ties},
                     {"losses", pair.data_sets.losses}});
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
          {"pairs", std::move(pairs)}};
}

}  // namespace

std::vector<MultiDatasetTable> multi_dataset_tables(std::span<const EvaluatedDataset> datasets, double alpha) {
  std::vector<MultiDatasetTable> tables;
  for (const std::string& protocol : protocols_of(datasets.front())) {
    const std::vector<const MethodScores*> first = scores_under(datasets.front(), protocol);
    for (const Average average : {Average::micro, Average::macro}) {
      for (std::size_t measure = 0; measure < first.front()->measures.size(); ++measure) {
        MultiDatasetTable table{.protocol = protocol,
                                .average = average,
                                .measure = first.front()->measures[measure],
                                .values = Eigen::MatrixXd(std::ssize(datasets), std::ssize(first)),
                                .ranks = {}};
        for (std::size_t set = 0; set < datasets.size(); ++set) {
          const std::vector<const MethodScores*> scores = scores_under(datasets[set], protocol);
          for (std::size_t method = 0; method < scores.size(); ++method) {
            table.values(static_cast<Eigen::Index>(set), static_cast<Eigen::Index>(method)) =
                average_of(*scores[method], static_cast<Eigen::Index>(measure), average);
          }
        }
        table.ranks = compare_by_ranks(table.values, alpha);
        tables.push_back(std::move(table));
      }
    }
  }
  return tables;
}

const MultiDatasetTable& main_table(const MultiDatasetResults& results) {
  return *std::ranges::find(results.tables, results.main_measure, &MultiDatasetTable::measure);
}

TextTable multi_dataset_summary(const MultiDatasetResults& results, const MultiDatasetTable& table, int decimals) {
  TextTable summary{.header = {"method"}, .rows = {}, .text_columns = 1};
  for (const EvaluatedDataset& dataset : results.datasets) summary.header.push_back(dataset.name);
  summary.header.insert(summary.header.end(), {"mean", "mean rank", "group"});
  const std::vector<std::string> letters = letters_of(table.ranks);
  for (std::size_t position = 0; position < letters.size(); ++position) {
    std::vector<std::string> row = summary_row(table, position, letters, decimals);
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

TextTable multi_dataset_csv_table(const MultiDatasetResults& results) {
  TextTable all{.header = {"protocol", "average", "measure"}, .rows = {}, .text_columns = 4};
  for (const MultiDatasetTable& table : results.tables) {
    const TextTable one = multi_dataset_summary(results, table, csv_style.decimals);
    if (all.rows.empty()) all.header.insert(all.header.end(), one.header.begin(), one.header.end());
    for (std::vector<std::string> row : one.rows) {
      row.insert(row.begin(), {table.protocol, name_of(table.average), table.measure});
      all.rows.push_back(std::move(row));
    }
  }
  return all;
}

TextTable multi_dataset_pairs_table(const MultiDatasetResults& results) {
  TextTable all{.header = {"protocol", "average", "measure", "first", "second", "difference_of_mean_ranks", "p", "wins",
                           "ties", "losses"},
                .rows = {},
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
                        .tables = {},
                        .main_measure = results.main_measure,
                        .failures = results.failures};
  for (const EvaluatedDataset& dataset : results.datasets) {
    page.datasets.push_back({.name = dataset.name,
                             .page = dataset.has_report ? fmt::format("{}/report.html", dataset.folder) : "",
                             .models = dataset.models,
                             .queries = dataset.scores.front().queries.size()});
  }
  for (const MultiDatasetTable& table : results.tables) {
    page.tables.push_back({.protocol = table.protocol,
                           .average = table.average,
                           .measure = table.measure,
                           .values = table.values,
                           .ranks = &table.ranks,
                           .letters = letters_of(table.ranks),
                           .words = test_words(results, table)});
  }
  return multi_dataset_page(page);
}

}  // namespace shapegauge
