#include "shapegauge/experiments/runner/assemble_signatures.h"

#include <tbb/parallel_for.h>

#include "shapegauge/retrieval/signature.h"

namespace shapegauge {

namespace {

/// The union of the ranges of a field over all models.
Interval common_range(const std::vector<const ModelDescription*>& models, std::size_t field) {
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return enclosing_interval(ranges);
}

/// One signature, a histogram, of all models.
Signatures histograms_of(const std::vector<const ModelDescription*>& models, const HistogramConfiguration& wanted,
                         std::size_t signature, std::size_t field) {
  Signatures table(static_cast<Eigen::Index>(models.size()), wanted.options.bins);
  const bool of_dataset = wanted.range == HistogramRange::dataset;
  const Interval range = of_dataset ? common_range(models, field) : Interval{};
  tbb::parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    table.row(static_cast<Eigen::Index>(i)) =
        of_dataset ? kept_histogram(models[i]->fields[field], range, wanted.options) : models[i]->histograms[signature];
  });
  return table;
}

}  // namespace

std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures) {
  std::vector<Signatures> tables(signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      tables[i] = histograms_of(models, signatures[i].histogram, i, field);
    }
  }
  for (const std::size_t i : computation_order(signatures)) {
    if (signatures[i].field) continue;
    std::vector<Signatures> parts;
    for (const std::size_t part : signatures[i].parts) parts.push_back(tables[part]);
    tables[i] = concatenate(parts);
  }
  return tables;
}

std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan) {
  std::vector<FieldReport> reports;
  for (std::size_t field = 0; field < plan.size(); ++field) {
    FieldReport& report = reports.emplace_back();
    report.settings = plan[field].field.settings;
    for (const ModelDescription* model : models) {
      report.seconds += model->fields[field].seconds;
      for (const auto& [outcome, count] : model->fields[field].outcomes) report.outcomes[outcome] += count;
    }
  }
  return reports;
}

ShapeReport report_shape(const ModelDescription& model) {
  ShapeReport report{.sha256 = model.sha256,
                     .diagnostics = model.diagnostics,
                     .chosen = model.chosen,
                     .area = model.area,
                     .noise = model.noise,
                     .pass_band = model.pass_band,
                     .outcomes = {},
                     .offsets = {},
                     .seconds = {}};
  for (const FieldDescription& field : model.fields) {
    report.outcomes.push_back(field.outcomes);
    report.offsets.push_back(field.offset);
    report.seconds.push_back(field.seconds);
  }
  return report;
}

std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field) {
  if (wanted.range == HistogramRange::fixed) return std::vector(models.size(), wanted.fixed);
  if (wanted.range == HistogramRange::dataset) return std::vector(models.size(), common_range(models, field));
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return ranges;
}

}  // namespace shapegauge
