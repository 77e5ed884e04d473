#include "shapegauge/experiments/command_line/requested_run.h"

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/configuration/apply_override.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/results/replay.h"

namespace shapegauge {

RequestedRun requested_run(const RunSource& source) {
  if (!source.replay.empty()) {
    RequestedRun request;
    request.recorded = read_manifest(source.replay);
    request.document = recorded_configuration(request.recorded, source.dataset_root);
    for (const std::string& assignment : source.overrides) apply_override(request.document, assignment);
    request.source = source.replay.string() + ": configuration";
    return request;
  }
  if (source.configuration.empty()) throw InputError("configuration is required; see 'shapegauge run --help'");
  if (!source.dataset_root.empty()) {
    throw InputError("--dataset-root goes with --replay; of a configuration, change it by --set dataset.root=FOLDER");
  }
  return {.document = read_configuration_document(source.configuration, source.overrides),
          .source = source.configuration.string(),
          .folder = source.configuration.parent_path(),
          .recorded = {}};
}

}  // namespace shapegauge
