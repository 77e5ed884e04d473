#include "shapegauge/experiments/results/field_warnings.h"

#include <fmt/format.h>

namespace shapegauge {

std::vector<std::string> field_warnings(std::span<const FieldReport> fields) {
  std::vector<std::string> warnings;
  for (const FieldReport& field : fields) {
    for (const char* outcome : {"undecided", "missing"}) {
      const auto count = field.outcomes.find(outcome);
      if (count == field.outcomes.end() || count->second == 0) continue;
      warnings.push_back(fmt::format("{} of {} samples {} in the field {}", count->second, field.outcomes.at("total"),
                                     outcome, field.settings.dump()));
    }
  }
  return warnings;
}

}  // namespace shapegauge
