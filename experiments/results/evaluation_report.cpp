#include "shapegauge/experiments/results/evaluation_report.h"

#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

std::string evaluation_report_page(const NamedEvaluation& named, const EvaluationData& data) {
  const DistanceOverview distances = overview_of(whole_matrix(data.distances), data.task.retrieval.query_classes);
  Report report;
  report.title = named.method;
  report.classes = data.task.class_names;
  report.ids = data.task.query_ids;
  report.labels = data.task.retrieval.query_classes;
  report.methods.push_back({.name = named.method,
                            .description = {},
                            .distances = &distances,
                            .evaluations = {named.evaluation, 1},
                            .histograms = {}});
  return report_page(report);
}

}  // namespace shapegauge
