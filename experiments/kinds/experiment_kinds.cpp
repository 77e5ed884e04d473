#include "shapegauge/experiments/kinds/experiment_kinds.h"

#include <nlohmann/json.hpp>

#include "shapegauge/experiments/multi_dataset/run_multi_dataset.h"
#include "shapegauge/experiments/retrieval/write_results.h"
#include "shapegauge/experiments/segmentation/write_segmentation.h"
#include "shapegauge/experiments/shape_comparison/write_shape_comparison.h"

namespace shapegauge {

Registry<ExperimentKind>& experiment_kinds() {
  static Registry<ExperimentKind> all("kind of experiment",
                                      {retrieval_kind(), comparison_kind(), segmentation_kind(), multi_dataset_kind()},
                                      has_functions<&ExperimentKind::describes, &ExperimentKind::read>);
  return all;
}

Experiment read_experiment(const nlohmann::json& document, const std::string& source,
                           const std::filesystem::path& folder) {
  const auto kinds = experiment_kinds().entries();
  const ExperimentKind* chosen = &kinds.front().get();
  for (const ExperimentKind& kind : kinds) {
    if (document.is_object() && kind.describes(document)) chosen = &kind;
  }
  return chosen->read(document, source, folder);
}

}  // namespace shapegauge
