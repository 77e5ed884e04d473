#include "shapegauge/pages/collection_page.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

using PageJson = nlohmann::ordered_json;

constexpr int table_digits = 6;

template <typename Values>
PageJson rounded_values(const Values& values) {
  PageJson json = PageJson::array();
  for (const double value : values) json.push_back(rounded(value, table_digits));
  return json;
}

PageJson page_table_json(const CollectionPageTable& table) {
  PageJson values = PageJson::array();
  for (Eigen::Index set = 0; set < table.values.rows(); ++set) {
    values.push_back(rounded_values(table.values.row(set)));
  }
  PageJson groups = PageJson::array();
  for (const HomogeneousGroup& group : table.ranks->groups) groups.push_back({group.first, group.last});
  PageJson pairs = PageJson::array();
  for (const RankDifference& pair : table.ranks->pairs) {
    pairs.push_back({{"first", pair.first},
                     {"second", pair.second},
                     {"p", rounded(pair.p, table_digits)},
                     {"counts", {pair.data_sets.wins, pair.data_sets.ties, pair.data_sets.losses}}});
  }
  return {{"protocol", table.protocol},
          {"average", name_of(table.average)},
          {"measure", table.measure},
          {"values", std::move(values)},
          {"mean_ranks", rounded_values(table.ranks->mean_ranks)},
          {"order", table.ranks->order},
          {"groups", std::move(groups)},
          {"letters", table.letters},
          {"critical_difference", rounded(table.ranks->critical_difference, table_digits)},  // null: none
          {"pairs", std::move(pairs)},
          {"words", table.words}};
}

PageJson collection_page_json(const CollectionPage& page) {
  PageJson datasets = PageJson::array();
  for (const CollectionPageDataset& dataset : page.datasets) {
    datasets.push_back(
        {{"name", dataset.name}, {"page", dataset.page}, {"models", dataset.models}, {"queries", dataset.queries}});
  }
  PageJson tables = PageJson::array();
  for (const CollectionPageTable& table : page.tables) tables.push_back(page_table_json(table));
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

std::string collection_page(const CollectionPage& page) {
  const std::string title = html_text(page.title);
  const std::string style = palette_style()
                                .append(page_files::common_style())
                                .append(page_files::report_style())
                                .append(page_files::collection_style());
  const std::string data = script_data(collection_page_json(page));
  const std::array<std::pair<std::string_view, std::string_view>, 5> marks{
      {{"{{title}}", title},
       {"{{style}}", style},
       {"{{libraries}}", page_files::chart_library()},
       {"{{data}}", data},
       {"{{script}}", page_files::collection_script()}}};
  return filled_page(page_files::collection_page(), marks);
}

}  // namespace shapegauge
