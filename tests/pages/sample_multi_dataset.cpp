// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pages/sample_multi_dataset.h"

#include <cmath>
#include <fmt/format.h>

namespace shapegauge::test_multi_dataset {

namespace {

constexpr Eigen::Index collected_sets = 14;
constexpr Eigen::Index collected_methods = 12;

/// Values that fall from method to method, each data set with errors of its own.
Eigen::MatrixXd collected_values(int variant) {
  Eigen::MatrixXd values(collected_sets, collected_methods);
  for (Eigen::Index set = 0; set < collected_sets; ++set) {
    for (Eigen::Index method = 0; method < collected_methods; ++method) {
      const double wild = std::sin(12.9898 * static_cast<double>(set * 31 + method * 7 + variant)) * 43758.5453;
      values(set, method) = 0.9 - 0.05 * static_cast<double>(method) + 0.3 * (wild - std::floor(wild)) - 0.2;
    }
  }
  return values;
}

MultiDatasetPage made_sample() {
  MultiDatasetPage page;
  page.title = "</title></script><script>alert(1)</script> & \"sets\"";
  page.description = "<b>All</b> of them.";
  page.methods = {"<img src=x> & co"};
  for (Eigen::Index method = 1; method < collected_methods; ++method) {
    page.methods.push_back(fmt::format("method {} of a name that is rather long", method + 1));
  }
  for (Eigen::Index set = 0; set < collected_sets; ++set) {
    page.datasets.push_back({.name = set == 0 ? "</script>" : fmt::format("set {}", set + 1),
                             .page = set % 2 == 0 ? fmt::format("set_{}/report.html", set + 1) : "",
                             .models = 100,
                             .queries = 90});
  }
  int variant = 0;
  for (const char* protocol : {"psb", "paper"}) {
    for (const Average average : {Average::micro, Average::macro}) {
      for (const char* measure : {"NN", "mAP"}) {
        const Eigen::MatrixXd values = collected_values(++variant);
        const RankComparison ranks = compare_by_ranks(values);
        page.tables.push_back({.protocol = protocol,
                               .average = average,
                               .measure = measure,
                               .values = values,
                               .ranks = ranks,
                               .rank_intervals = rank_intervals(ranks.ranks)});
        page.words.emplace_back("Friedman's test: chi-squared 1.00.");
      }
    }
  }
  page.main_measure = "mAP";
  page.failures = {{"gone <i>", "no such folder </script>"}};
  return page;
}

}  // namespace

const MultiDatasetPage& sample_multi_dataset() {
  static const MultiDatasetPage sample = made_sample();
  return sample;
}

}  // namespace shapegauge::test_multi_dataset
