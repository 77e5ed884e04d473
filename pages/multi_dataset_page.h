// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/friedman_test.h"

namespace shapegauge {

/// A data set on the page of a multi-dataset experiment.
struct MultiDatasetPageDataset {
  std::string name;
  std::string page;  ///< relative address of its report; empty: none
  std::size_t models = 0;
  std::size_t queries = 0;
};

/// Methods by data sets under one protocol, measure and average.
struct MultiDatasetTable {
  std::string protocol;
  Average average = Average::micro;
  std::string measure;
  Eigen::MatrixXd values;        ///< data sets x methods, fractions
  Eigen::MatrixXd deviations{};  ///< of the values over repetitions, NaN for single ones; empty if all are
  RankComparison ranks;
  std::vector<RankInterval> rank_intervals{};  ///< per method; may be empty
};

/// Returns the letters of the groups that do not differ significantly, by position in the order of the ranks.
std::vector<std::string> letters_of(const RankComparison& ranks);

/// Contents of the page of a multi-dataset experiment.
struct MultiDatasetPage {
  std::string title;
  std::string description;
  std::vector<std::string> methods;
  std::vector<MultiDatasetPageDataset> datasets;
  std::vector<MultiDatasetTable> tables;  ///< every combination of the protocols, averages and measures
  std::vector<std::string> words;         ///< about the tests of each table
  std::string main_measure;               ///< shown first
  std::vector<std::pair<std::string, std::string>> failures;  ///< data sets left out, and why
};

/// The page as one HTML file that needs nothing else; it leads to the reports of the data sets.
std::string multi_dataset_page(const MultiDatasetPage& page);

}  // namespace shapegauge
