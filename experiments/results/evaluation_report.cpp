// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/evaluation_report.h"

#include <deque>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/distance_overview.h"

namespace shapegauge {

std::string evaluation_report_page(const std::vector<ReportedEvaluation>& methods, ReportTests tests) {
  const EvaluationTask& task = methods.front().data->task;
  std::deque<DistanceOverview> overviews;
  Report report;
  report.classes = task.class_names;
  report.ids = task.query_ids;
  report.tests = std::move(tests);
  report.labels = task.retrieval.query_classes;
  std::vector<std::string> names;
  for (const auto& [named, data] : methods) {
    if (data->task.query_ids != task.query_ids || data->task.retrieval.query_classes != task.retrieval.query_classes) {
      throw InputError(
          fmt::format("a report requires matrices of the same models in the same order, unlike those of {} and {}",
                      methods.front().named.method, named.method));
    }
    overviews.push_back(overview_of(whole_matrix(data->distances), data->task.retrieval.query_classes));
    report.methods.push_back({.name = named.method,
                              .distance = {},
                              .settings = {},
                              .distances = &overviews.back(),
                              .evaluations = {named.evaluation, 1},
                              .intervals = {named.intervals},
                              .histograms = {}});
    names.push_back(named.method);
  }
  report.title = fmt::format("{}", fmt::join(names, ", "));
  return report_page(report);
}

std::string evaluation_report_page(const NamedEvaluation& named, const EvaluationData& data) {
  return evaluation_report_page({{.named = named, .data = &data}});
}

}  // namespace shapegauge
