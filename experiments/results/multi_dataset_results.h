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

/// Data set of a multi-dataset experiment with the scores of all methods.
struct EvaluatedDataset {
  std::string name;        ///< name of the data set
  std::string folder;      ///< folder of the data set's results, relative to the folder of all results
  std::string page;        ///< address of the data set's page, relative to the folder of all results; empty if none
  std::size_t models = 0;  ///< number of models of the data set
  std::vector<MethodScores> scores;  ///< scores, one entry per method and protocol
  /// For each of `scores`: standard deviation over repetitions of the micro (macro) average of each measure. Empty
  /// for an experiment, which has no repetitions.
  /// @{
  std::vector<Eigen::VectorXd> micro_deviations{};
  std::vector<Eigen::VectorXd> macro_deviations{};
  /// @}
};

/// Results of methods on several data sets: scores per data set, tables with ranks and tests, failures.
struct MultiDatasetResults {
  std::string name;                        ///< name of the experiment
  std::string description;                 ///< description for pages; empty if there is none
  std::vector<std::string> methods;        ///< names of the methods
  std::vector<EvaluatedDataset> datasets;  ///< data sets with the scores of all methods
  std::vector<MultiDatasetTable> tables;   ///< one table per protocol, average and measure
  std::string main_measure;                ///< measure in summaries: mAP if it is computed, else the first
  double alpha = 0.05;                     ///< significance level of the tests
  std::vector<std::pair<std::string, std::string>> failures;  ///< names of data sets left out, and the reasons
};

/// Makes a table of methods by data sets for each protocol, average and measure, with ranks and tests at level alpha.
/// All data sets must have the same methods, protocols and measures. With `intervals` and at least two data sets, ranks
/// have confidence intervals at 1 - alpha.
std::vector<MultiDatasetTable> multi_dataset_tables(std::span<const EvaluatedDataset> datasets, double alpha,
                                                    const std::optional<ResamplingOptions>& intervals = std::nullopt);

/// Returns the table that summaries show: first protocol, average over queries, main measure.
const MultiDatasetTable& main_table(const MultiDatasetResults& results);

/// Makes a table with a row for each method, the best mean rank first: its average on each data set, with the standard
/// deviation over repetitions, the mean over data sets, the mean rank, the confidence interval of the rank, and the
/// letters of the groups that do not differ significantly. The best of each data set is bold.
TextTable multi_dataset_summary(const MultiDatasetResults& results, const MultiDatasetTable& table,
                                const ScoreStyle& style = {});

/// Makes a table for files: the rows of multi_dataset_summary() for all tables, preceded by protocol, average and
/// measure.
TextTable multi_dataset_csv_table(const MultiDatasetResults& results, const ScoreStyle& style = csv_style);

/// Makes a table for files with a row for each table and pair of methods: difference of the mean ranks, p of Nemenyi's
/// test, numbers of data sets that the first method wins, ties, loses.
TextTable multi_dataset_pairs_table(const MultiDatasetResults& results);

/// Formats all results as JSON, with scores as fractions.
nlohmann::ordered_json multi_dataset_json(const MultiDatasetResults& results);

/// Explains Friedman's test and the critical difference of a table in a sentence or two.
std::string test_words(const MultiDatasetResults& results, const MultiDatasetTable& table);

/// Renders the results as one HTML file.
std::string multi_dataset_html(const MultiDatasetResults& results);

}  // namespace shapegauge
