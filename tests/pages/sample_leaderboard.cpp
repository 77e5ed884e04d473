// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pages/sample_leaderboard.h"

#include <cmath>
#include <fmt/format.h>

namespace shapegauge::test_leaderboard {

namespace {

constexpr int models = 24;
constexpr int methods = 30;

std::vector<int> sample_labels() {
  std::vector<int> labels;
  for (int model = 0; model < models; ++model) labels.push_back(model % 4);
  return labels;
}

/// Distances of points on a line, near each other in a class, with errors that grow with the method's number.
DistanceMatrix sample_distances(int method, const std::vector<int>& labels) {
  DistanceMatrix distances(models, models);
  for (int i = 0; i < models; ++i) {
    for (int j = 0; j < models; ++j) {
      const double error = std::sin(12.9898 * (i * models + j) + 78.233 * (method + 1)) * 43758.5453;
      const bool same = labels[static_cast<std::size_t>(i)] == labels[static_cast<std::size_t>(j)];
      distances(i, j) = (same ? 1 : 2) + 0.06 * (method + 1) * (error - std::floor(error));
    }
  }
  return distances;
}

SampleLeaderboard made_leaderboard() {
  SampleLeaderboard sample;
  const std::vector<int> labels = sample_labels();
  for (int method = 0; method < methods; ++method) {
    sample.evaluations.push_back(evaluate(sample_distances(method, labels), labels, {}));
  }
  LeaderboardPage& page = sample.page;
  page.title = "</title><script>alert(1)</script> & \"board\"";
  page.facts = {{"protocol", "psb"}};
  page.classes = {"<b>ants</b>", "</script>", "cups", "hands"};
  page.labels = labels;
  page.significance = "Intervals over classes.";
  page.refused = {{"bad<i>.npy", "row 3 </script> is NaN"}, {"small.csv", "3 rows"}};
  page.csv = "rank,method\n1,\"</script>\"\n";
  page.latex = "\\begin{tabular}{l}\\end{tabular}\n";
  for (std::size_t method = 0; method < methods; ++method) {
    page.entries.push_back({.name = method == 0 ? "<img src=x> & co" : fmt::format("method {}", method + 1),
                            .authors = method % 3 == 0 ? "A. Author, B. <Bee>" : "",
                            .paper = method % 3 == 0 ? "A paper, 2020" : "",
                            .url = method % 6 == 0 ? "https://example.org/?a=1&b=\"2\"" : "",
                            .file = fmt::format("m{}.npy", method),
                            .page = method % 2 == 0 ? fmt::format("methods/m{}.html", method) : "",
                            .warnings = {}});
    if (method < 2) page.entries.back().warnings = {"rows are assumed to be in natural order"};
  }
  for (std::size_t i = 0; i < page.entries.size(); ++i) page.entries[i].evaluation = &sample.evaluations[i];
  for (std::size_t measure = 0; measure < sample.evaluations[0].measures.size(); ++measure) {
    Eigen::MatrixXd values(models, methods);
    for (Eigen::Index method = 0; method < methods; ++method) {
      values.col(method) =
          sample.evaluations[static_cast<std::size_t>(method)].per_query.col(static_cast<Eigen::Index>(measure));
    }
    page.micro.push_back(
        standings_of(values, labels, {.blocks = ResamplingUnit::queries, .resampling = {.resamples = 500}}));
    page.macro.push_back(standings_of(values, labels, {.average = Average::macro, .resampling = {.resamples = 500}}));
  }
  page.rank_by = 5;
  return sample;
}

}  // namespace

const SampleLeaderboard& sample_leaderboard() {
  static const SampleLeaderboard sample = made_leaderboard();
  return sample;
}

}  // namespace shapegauge::test_leaderboard
