// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/kinds/experiment_kinds.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/dataset_files.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/multi_dataset/run_multi_dataset.h"
#include "shapegauge/experiments/retrieval/write_results.h"
#include "shapegauge/experiments/segmentation/write_segmentation.h"
#include "shapegauge/experiments/shape_comparison/write_shape_comparison.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;
using Kinds = std::vector<std::reference_wrapper<const ExperimentKind>>;

/// Throws ArgumentError for a kind that no document can have, whose paths are no patterns, or whose schema has
/// definitions.
void check_kind(const ExperimentKind& kind) {
  if (kind.keys.empty())
    throw ArgumentError(fmt::format("the kind of experiment \"{}\" needs keys, and has none", kind.name));
  if (kind.schema().contains("definitions")) {
    throw ArgumentError(
        fmt::format("the kind of experiment \"{}\": a schema cannot have definitions of its own", kind.name));
  }
  for (const auto* const patterns : {&kind.paths.files, &kind.paths.datasets}) {
    for (const std::string& pattern : *patterns) {
      if (pattern.starts_with('/')) continue;
      throw ArgumentError(
          fmt::format("the kind of experiment \"{}\": the path \"{}\" must begin with a slash", kind.name, pattern));
    }
  }
}

/// Returns the kinds that recognise the document; the first kind if none does.
Kinds kinds_of(const Json& document) {
  const Kinds all = experiment_kinds().entries();
  Kinds found;
  std::ranges::copy_if(all, std::back_inserter(found), [&](const ExperimentKind& kind) {
    return std::ranges::all_of(kind.keys, [&](const std::string& key) { return document.contains(key); });
  });
  return found.empty() ? Kinds{all.front()} : found;
}

/// Returns the kind of the document. Throws InputError for a document of several kinds.
const ExperimentKind& kind_of(const Json& document, const std::string& source) {
  const Kinds found = kinds_of(document);
  if (found.size() == 1) return found.front();
  std::vector<std::string> named;
  for (const ExperimentKind& kind : found) {
    named.push_back(fmt::format("{} (\"{}\")", kind.name, fmt::join(kind.keys, "\", \"")));
  }
  throw InputError(
      fmt::format("{}: the keys are those of several kinds of experiments: {}; leave out those of all but one", source,
                  fmt::join(named, ", ")));
}

}  // namespace

Registry<ExperimentKind>& experiment_kinds() {
  static Registry<ExperimentKind> all("kind of experiment",
                                      {retrieval_kind(), comparison_kind(), segmentation_kind(), multi_dataset_kind()},
                                      has_functions<&ExperimentKind::schema, &ExperimentKind::read>, check_kind);
  return all;
}

Experiment read_experiment(const Json& document, const std::string& source, const std::filesystem::path& folder) {
  const ExperimentKind& kind = kind_of(document, source);
  Json complete = document;
  const auto files = read_dataset_files(complete, source, folder, kind.paths.datasets);
  check_by_schema(complete, kind.schema(), source);
  Experiment experiment = kind.read(complete, source, folder);
  experiment.input_paths.insert(experiment.input_paths.end(), files.begin(), files.end());
  return experiment;
}

DocumentPaths experiment_paths(const Json& document) { return kinds_of(document).front().get().paths; }

std::string experiment_schema() {
  const Kinds kinds = experiment_kinds().entries();
  std::vector<std::string> described;
  for (const ExperimentKind& kind : kinds) {
    described.push_back(fmt::format("{} ({}): {}", kind.name, fmt::join(kind.keys, ", "), kind.description));
  }
  OrderedJson choice = kinds.front().get().schema();
  for (std::size_t i = kinds.size() - 1; i > 0; --i) {
    const ExperimentKind& kind = kinds[i];
    choice = {{"if", {{"required", kind.keys}}}, {"then", kind.schema()}, {"else", std::move(choice)}};
  }
  OrderedJson schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                     {"title", "shapegauge experiment"},
                     {"description", fmt::format("One experiment. {}", fmt::join(described, " "))}};
  schema.update(choice);
  schema["definitions"] = schema_definitions();
  return schema.dump(2) + "\n";
}

}  // namespace shapegauge
