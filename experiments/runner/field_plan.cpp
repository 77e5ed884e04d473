#include "shapegauge/experiments/runner/field_plan.h"

#include <algorithm>

namespace shapegauge {

std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<PlannedField> plan;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const SignatureConfiguration& signature = signatures[i];
    if (!signature.field) continue;
    auto planned = std::ranges::find_if(
        plan, [&](const PlannedField& known) { return known.field.settings == signature.field->settings; });
    if (planned == plan.end())
      planned = plan.insert(plan.end(), PlannedField{.field = *signature.field, .signatures = {}});
    planned->signatures.push_back(i);
    if (signature.histogram.range == HistogramRange::dataset) planned->keep_values = true;
  }
  return plan;
}

bool is_pictured(const PlannedField& planned, const ReportConfiguration& report) {
  return report.wanted && report.pictures &&
         std::ranges::find(planned.signatures, report.pictured_signature) != planned.signatures.end();
}

}  // namespace shapegauge
