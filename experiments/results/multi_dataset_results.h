// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/pages/multi_dataset_page.h"

namespace shapegauge {

/// A data set that was used.
struct EvaluatedDataset {
  std::string name;
  std::string folder;  ///< of its results, below those of the experiment
  std::string page;    ///< address of its page, below the results; empty for none
  std::size_t models = 0;
  std::vector<MethodScores> scores;  ///< per method and protocol
  /// Standard deviations of the averages over repetitions, by score and measure; empty without repetitions.
  /// @{
  std::vector<Eigen::VectorXd> micro_deviations{};
  std::vector<Eigen::VectorXd> macro_deviations{};
  /// @}
};

/// Results of methods on several data sets.
struct MultiDatasetResults {
  std::string name;
  std::string description;
  std::vector<std::string> methods;
  std::vector<EvaluatedDataset> datasets;
  std::vector<MultiDatasetTable> tables;  ///< by protocol, average, measure
  std::string main_measure;               ///< mAP, or the first measure where that is not among them
  double alpha = 0.05;
  std::vector<std::pair<std::string, std::string>> failures;  ///< data sets left out, and why
};

/// Compares the methods on all data sets, which all have the same methods, protocols and measures. Ranks have intervals
/// at 1 - alpha if there are options for these, and several data sets.
std::vector<MultiDatasetTable> multi_dataset_tables(std::span<const EvaluatedDataset> datasets, double alpha,
                                                    const std::optional<ResamplingOptions>& intervals = std::nullopt);

/// The table of the first protocol, average and main measure: that which summaries show.
const MultiDatasetTable& main_table(const MultiDatasetResults& results);

/// A row for each method, the best mean rank first: its value on each data set, with the standard deviation
/// over repetitions, their mean, the mean rank, the interval of the rank, and the letters of the groups that do not
/// differ significantly. The best of each data set is bold.
TextTable multi_dataset_summary(const MultiDatasetResults& results, const MultiDatasetTable& table,
                                const ScoreStyle& style = {});

/// For files: the rows of all tables, with protocol, average and measure in front.
TextTable multi_dataset_csv_table(const MultiDatasetResults& results, const ScoreStyle& style = csv_style);

/// For files: a row for each table and pair of methods: difference of the mean ranks, p of Nemenyi's test, data sets
/// won, tied and lost.
TextTable multi_dataset_pairs_table(const MultiDatasetResults& results);

/// All of it as JSON, in fractions.
nlohmann::ordered_json multi_dataset_json(const MultiDatasetResults& results);

/// Friedman's test and the critical difference in a sentence or two.
std::string test_words(const MultiDatasetResults& results, const MultiDatasetTable& table);

/// The page of the results as one HTML file.
std::string multi_dataset_html(const MultiDatasetResults& results);

}  // namespace shapegauge
