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
  std::string name;         ///< name of the data set
  std::string page;         ///< relative address of the data set's report; empty for none
  std::size_t models = 0;   ///< number of models of the data set
  std::size_t queries = 0;  ///< number of queries of the data set
};

/// Results of methods on several data sets by one protocol, measure and average, with comparisons of ranks.
struct MultiDatasetTable {
  std::string protocol;              ///< name of the protocol
  Average average = Average::micro;  ///< whether `values` are averages over queries (micro) or classes (macro)
  std::string measure;               ///< name of the measure
  Eigen::MatrixXd values;        ///< averages of the measure as fractions, one row per data set, one column per method
  Eigen::MatrixXd deviations{};  ///< standard deviations of `values` over repetitions; NaN or empty without repetitions
  RankComparison ranks;          ///< mean ranks of the methods over the data sets, with a test of their differences
  std::vector<RankInterval> rank_intervals{};  ///< confidence interval of each method's rank; empty if not computed
};

/// Returns one string of significance letters per method, in the order of ranks.order. Methods that share a letter do
/// not differ significantly.
std::vector<std::string> letters_of(const RankComparison& ranks);

/// Contents of the page of a multi-dataset experiment.
struct MultiDatasetPage {
  std::string title;                              ///< title of the page
  std::string description;                        ///< description of the experiment; empty if there is none
  std::vector<std::string> methods;               ///< names of the methods
  std::vector<MultiDatasetPageDataset> datasets;  ///< data sets of the experiment
  std::vector<MultiDatasetTable> tables;          ///< one table per combination of protocol, average and measure
  std::vector<std::string> words;                 ///< explanation of the significance tests, one text per table
  std::string main_measure;                       ///< name of the measure that is shown first
  std::vector<std::pair<std::string, std::string>> failures;  ///< names of omitted data sets and the reasons
};

/// Renders the page as one self-contained HTML file with links to the reports of the data sets.
std::string multi_dataset_page(const MultiDatasetPage& page);

}  // namespace shapegauge
