// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/multi_dataset_page.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/metrics/homogeneous_groups.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/score_json.h"

namespace shapegauge {

namespace {

using PageJson = nlohmann::ordered_json;

PageJson page_table_json(const MultiDatasetTable& table, const std::string& words) {
  PageJson groups = PageJson::array();
  for (const HomogeneousGroup& group : table.ranks.groups) groups.push_back({group.first, group.last});
  PageJson intervals = PageJson::array();
  for (const auto& [best, worst] : table.rank_intervals) intervals.push_back({best, worst});
  PageJson pairs = PageJson::array();
  for (const RankDifference& pair : table.ranks.pairs) {
    pairs.push_back({{"first", pair.first},
                     {"second", pair.second},
                     {"p", rounded_to_digits(pair.p, score_digits)},
                     {"counts", {pair.data_sets.wins, pair.data_sets.ties, pair.data_sets.losses}}});
  }
  return {{"protocol", table.protocol},
          {"average", name_of(table.average)},
          {"measure", table.measure},
          {"values", rounded_rows(table.values)},
          {"deviations", rounded_rows(table.deviations)},  // null: none
          {"mean_ranks", rounded_scores(table.ranks.mean_ranks)},
          {"rank_intervals", std::move(intervals)},
          {"order", table.ranks.order},
          {"groups", std::move(groups)},
          {"letters", letters_of(table.ranks)},
          {"critical_difference", rounded_to_digits(table.ranks.critical_difference, score_digits)},  // null: none
          {"pairs", std::move(pairs)},
          {"words", words}};
}

PageJson multi_dataset_page_json(const MultiDatasetPage& page) {
  PageJson datasets = PageJson::array();
  for (const MultiDatasetPageDataset& dataset : page.datasets) {
    datasets.push_back(
        {{"name", dataset.name}, {"page", dataset.page}, {"models", dataset.models}, {"queries", dataset.queries}});
  }
  PageJson tables = PageJson::array();
  for (std::size_t i = 0; i < page.tables.size(); ++i) tables.push_back(page_table_json(page.tables[i], page.words[i]));
  return {{"version", version()},
          {"title", page.title},
          {"description", page.description},
          {"methods", page.methods},
          {"datasets", std::move(datasets)},
          {"main_measure", page.main_measure},
          {"tables", std::move(tables)},
          {"failures", page.failures}};
}

}  // namespace

std::vector<std::string> letters_of(const RankComparison& ranks) {
  return compact_letters(ranks.order.size(), ranks.groups);
}

std::string multi_dataset_page(const MultiDatasetPage& page) {
  return scripted_page({.title = page.title,
                        .kind = "report of several data sets",
                        .main = page_files::multi_dataset_page(),
                        .styles = {page_files::report_style(), page_files::multi_dataset_style()},
                        .libraries = {page_files::chart_library()},
                        .data = multi_dataset_page_json(page),
                        .script = page_files::multi_dataset_script()});
}

}  // namespace shapegauge
