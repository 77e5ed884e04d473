// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pages/sample_reports.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/pages/shape_view.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_report {

namespace {

constexpr int models = 12;
const std::vector<int> labels = {0, 1, 0, 1, 0, 1, 0, 1, 0, 2, 0, 1};

/// Histograms of two bumps, at bins that depend on the class and a little on the model.
Signatures histograms(int bins, double spread) {
  Signatures table(models, bins);
  for (int i = 0; i < models; ++i) {
    const double centre = bins * (0.3 + 0.15 * labels[static_cast<std::size_t>(i)]) + spread * (i % 5);
    for (int bin = 0; bin < bins; ++bin) {
      table(i, bin) = static_cast<float>(std::exp(-0.1 * (bin - centre) * (bin - centre)) + 0.01);
    }
    table.row(i) /= table.row(i).sum();
  }
  return table;
}

std::vector<Evaluation> evaluations_of(const DistanceMatrix& distances) {
  return {evaluate(distances, labels, {.protocol = Protocol::psb}),
          evaluate(distances, labels, {.protocol = Protocol::paper})};
}

/// A picture and a view of each model, coloured by distances from the middle.
void add_shapes(Report& report) {
  for (const int label : labels) {
    ShapeView view{.name = "", .shape = test::box({1, 0.3 + 0.1 * label, 0.2}, 3), .site = SampleSite::vertices};
    const Points& points = view.shape.vertices;
    view.fields = {{.name = "", .values = points.col(0).cwiseAbs(), .colours = {0, 1}},
                   {.name = "", .values = points.rowwise().norm(), .colours = {0, 1}}};
    report.pictures.png.push_back(shape_view_picture(view, 96));
    report.views.shapes.push_back(shape_view_json(view).dump());
  }
  report.pictures.field = "<field>";
  report.views.fields = {{.name = "<field>", .colours = report.pictures.range},
                         {.name = "</script><i>away", .colours = std::nullopt}};
}

void add_hostile_words(Report& report) {
  report.title = "</title></script><script>alert(1)</script> {{data}} & \"quotes\"";
  report.description =
      "<img src=x onerror=alert(1)> <!-- <script> ]]> \xe2\x80\xa8 \xc3\xa9\xe6\xa8\xa1\xf0\x9f\x90\x8e \\u003c";
  report.facts = {{"Distance", "l1 <b>&amp;</b>"}};
  report.classes = {"<b>ants</b> & 'co'", "</script>", "\xe9\xa6\xac \"horses\" \\"};
  for (int i = 0; i < models; ++i) report.ids.push_back(fmt::format("{}</script><!--&lt;\"'`{{{{script}}}}", i));
  report.ids[3] = "bytes that are no text: \xff\xfe";
  report.ids[4] = "";
  report.ids[5] = "__proto__";
  report.labels = labels;
  report.perturbations = {{"noise <i>", {{"amplitude", "0.01"}}}, {"one of", {{"choices", "type flip; type crack"}}}};
  report.leaks = {{.id = "4 & <b>", .field = "type </th>offset_sdf, offset 0.03", .offset = 0.03, .gap = 0.05}};
  report.warnings = {"3 of 10 samples missing in the field {\"type\":\"<i>\"}"};
  report.failures = {{"T</td>", "line 3: \"<script>\" is no number"}};
}

/// Intervals of a hundredth to either side.
std::vector<EvaluationIntervals> intervals_around(const std::vector<Evaluation>& evaluations) {
  const auto around = [](const Eigen::VectorXd& values) {
    std::vector<ConfidenceInterval> intervals;
    for (const double value : values) intervals.push_back({.low = value - 0.01, .high = value + 0.01});
    return intervals;
  };
  std::vector<EvaluationIntervals> all;
  for (const Evaluation& evaluation : evaluations) {
    all.push_back({.confidence = 0.9, .micro = around(evaluation.micro), .macro = around(evaluation.macro)});
  }
  return all;
}

SampleReport make_hostile_report() {
  SampleReport sample;
  sample.signatures = {histograms(20, 0.3), histograms(30, 0.8)};
  for (const Signatures& table : sample.signatures) sample.distances.push_back(distance_matrix(table));
  sample.distances.emplace_back(sample.distances[0] + sample.distances[1]);
  for (const DistanceMatrix& distances : sample.distances) {
    sample.overviews.push_back(overview_of(distances, labels));
    sample.evaluations.push_back(evaluations_of(distances));
  }
  add_hostile_words(sample.report);
  add_shapes(sample.report);
  return sample;
}

/// Distances that separate classes the less, the larger their random share.
DistanceMatrix distances_with_errors(double size) {
  DistanceMatrix distances(models, models);
  for (int i = 0; i < models; ++i) {
    for (int j = 0; j < models; ++j) distances(i, j) = std::abs(labels[i] - labels[j]) + size * ((7 * i + 3 * j) % 11);
  }
  return distances;
}

/// A report of these distance matrices and nothing else.
SampleReport report_of(std::string title, std::vector<DistanceMatrix> distances) {
  SampleReport sample;
  sample.distances = std::move(distances);
  for (const DistanceMatrix& matrix : sample.distances) {
    sample.overviews.push_back(overview_of(matrix, labels));
    sample.evaluations.push_back({evaluate(matrix, labels, {})});
  }
  sample.report.title = std::move(title);
  sample.report.classes = {"a", "b", "c"};
  for (int i = 0; i < models; ++i) sample.report.ids.push_back(fmt::format("{}", i));
  sample.report.labels = labels;
  return sample;
}

SampleReport make_plain_report() {
  DistanceMatrix distances = distances_with_errors(0.1);
  distances(2, 5) = std::numeric_limits<double>::infinity();
  return report_of("plain", {distances});
}

SampleReport make_crowded_report() {
  constexpr int methods = 16;
  std::vector<DistanceMatrix> distances;
  for (int i = 0; i < methods; ++i) distances.push_back(distances_with_errors(0.03 * i));
  return report_of("crowded", std::move(distances));
}

/// Adds methods without histograms.
void add_methods(SampleReport& sample, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    sample.report.methods.push_back({.name = names[i],
                                     .distance = {},
                                     .settings = {},
                                     .distances = &sample.overviews[i],
                                     .evaluations = sample.evaluations[i],
                                     .intervals = {},
                                     .histograms = {}});
  }
}

}  // namespace

const SampleReport& hostile_report() {
  static SampleReport sample = make_hostile_report();
  if (!sample.report.methods.empty()) return sample;
  const std::vector<std::string> names = {"<i>first</i> & \"best\"", "</script><script>alert(2)</script>",
                                          "first + second"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    ReportMethod method{.name = names[i],
                        .distance = "l1 <b>",
                        .settings = {{"bins & <ranges>", "</td><script>alert(3)</script>"}, {"offset", "0.03"}},
                        .distances = &sample.overviews[i],
                        .evaluations = sample.evaluations[i],
                        .intervals = intervals_around(sample.evaluations[i]),
                        .histograms = {}};
    if (i < 2)
      method.histograms = {.table = &sample.signatures[i], .ranges = std::vector<Interval>(models), .parts = {}};
    if (i == 2) method.histograms.parts = {0, 1};
    sample.report.methods.push_back(method);
  }
  return sample;
}

const SampleReport& plain_report() {
  static SampleReport sample = make_plain_report();
  if (sample.report.methods.empty()) add_methods(sample, {"plain"});
  return sample;
}

const SampleReport& crowded_report() {
  static SampleReport sample = make_crowded_report();
  if (!sample.report.methods.empty()) return sample;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < sample.distances.size(); ++i) {
    names.push_back(fmt::format("errors {}{}", i, i % 3 == 0 ? " of a method that takes many words to name" : ""));
  }
  add_methods(sample, names);
  return sample;
}

}  // namespace shapegauge::test_report
