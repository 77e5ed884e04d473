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

/// Data set on the page of a multi-dataset experiment.
struct MultiDatasetPageDataset {
  std::string name;
  std::string page;  ///< relative address of the data set's report; empty for none
  std::size_t models = 0;
  std::size_t queries = 0;
};

/// Results of methods on several data sets by one protocol, measure and average, with comparisons of ranks.
struct MultiDatasetTable {
  std::string protocol;
  Average average = Average::micro;
  std::string measure;
  Eigen::MatrixXd values;        ///< values of the measure as fractions, data sets x methods
  Eigen::MatrixXd deviations{};  ///< standard deviations of `values` over repetitions; NaN or empty without repetitions
  RankComparison ranks;
  std::vector<RankInterval> rank_intervals{};  ///< confidence interval of each method's rank; may be empty
};

/// Returns the letters of each method, in the order of ranks.order. Methods that share a letter do not differ
/// significantly.
std::vector<std::string> letters_of(const RankComparison& ranks);

/// Contents of the page of a multi-dataset experiment.
struct MultiDatasetPage {
  std::string title;
  std::string description;
  std::vector<std::string> methods;
  std::vector<MultiDatasetPageDataset> datasets;
  std::vector<MultiDatasetTable> tables;  ///< one table per combination of protocol, average and measure
  std::vector<std::string> words;         ///< explanation of the significance tests, one per table
  std::string main_measure;               ///< name of the measure that is shown first
  std::vector<std::pair<std::string, std::string>> failures;  ///< names of omitted data sets and the reasons
};

/// Renders the page as one self-contained HTML file with links to the reports of the data sets.
std::string multi_dataset_page(const MultiDatasetPage& page);

}  // namespace shapegauge
