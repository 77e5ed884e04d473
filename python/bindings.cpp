// SPDX-License-Identifier: GPL-3.0-or-later
// The native half of the Python package: arrays in, arrays out. Checks of arguments and docstrings are in
// shapegauge/*.py. Other functions are in the files *_bindings.cpp.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "python/native.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/setting_names.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/derived_distances.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/experiments/kinds/experiment_kinds.h"
#include "shapegauge/retrieval/rerank.h"

namespace py = pybind11;

namespace shapegauge {

RunControl interruptible_control(int threads, Cancellation& cancellation, const PythonProgress& progress) {
  RunControl control{
      .threads = threads, .interrupted = [&] { return cancellation.requested(); }, .cancellation = &cancellation};
  if (progress) {
    control.progress = [&progress](std::string_view stage, std::size_t done, std::size_t total) {
      const py::gil_scoped_acquire acquired;
      (*progress)(std::string(stage), done, total);
    };
  }
  return control;
}

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Re-ranks the distances; returns them with warnings.
py::tuple rerank(const Eigen::Ref<const DistanceMatrix>& distances, const std::string& method,
                 const std::string& settings, int threads) {
  std::vector<std::string> warnings;
  DistanceMatrix reranked = compute(threads, [&] {
    const RerankMethod& chosen = rerank_methods().at(method);
    DistanceMatrix result = chosen.rerank(distances, read_only_parameters(chosen.parameters, Json::parse(settings)));
    warnings =
        rerank_warnings({.rows = distances.rows(),
                         .columns = distances.cols(),
                         .read = [&](const MatrixBlock& block) -> DistanceMatrix {
                           return distances.block(block.first_row, block.first_column, block.rows, block.columns);
                         }});
    return result;
  });
  return py::make_tuple(array_of(std::move(reranked)), warnings);
}

/// Computes the sum of distances with the terms in `settings`, as in a signature of a configuration.
py::array fuse(const std::vector<DistanceMatrix>& distances, const std::string& settings, int threads) {
  return array_of(compute(threads, [&] { return derive(make_derived("sum", Json::parse(settings)), distances); }));
}

/// Spells the settings that a message names as arguments: ties='index'.
std::string with_arguments(const std::string& message) {
  return spell_settings(message, [](std::string_view name, std::string_view value) {
    if (value.empty()) return std::string(name);
    const bool is_bool = value == "true" || value == "false";
    const std::string text = is_bool ? (value == "true" ? "True" : "False") : std::string(value);
    const bool is_word = !is_bool && !parse_number(text);
    return std::string(name) + (is_word ? "='" + text + "'" : "=" + text);
  });
}

/// Results of a run for Python.
struct FinishedRun {
  std::string summary;
  std::vector<std::string> warnings;
  std::vector<std::string> left_out;
};

/// Runs the configuration `document` (JSON) or, if it is empty, that of the file `source`, which is its name in
/// messages. Relative paths are relative to `folder`.
FinishedRun run_configuration(const std::string& document, const std::string& source, const fs::path& folder,
                              const std::vector<std::string>& overrides, const fs::path& output, bool replace,
                              const std::optional<fs::path>& cache_folder, int threads,
                              const PythonProgress& progress) {
  FinishedRun finished;
  Cancellation cancellation;
  const RunControl control = interruptible_control(threads, cancellation, progress);
  run_interruptibly(cancellation, [&] {
    Json configuration = document.empty() ? read_json(source) : parse_json(document, source);
    std::vector<fs::path> files = apply_overrides(configuration, source, folder, overrides, experiment_paths);
    if (document.empty()) files.emplace_back(source);
    Experiment experiment = read_experiment(configuration, source, folder);
    std::ranges::move(files, std::back_inserter(experiment.input_paths));
    Cache cache(cache_folder.value_or(default_cache_folder()), false);
    RunOutcome outcome = run_into_folder(experiment, output, replace, control, cache);
    finished = {.summary = std::move(outcome.summary), .warnings = std::move(outcome.warnings), .left_out = {}};
    for (const LeftOutShape& one : outcome.left_out) finished.left_out.push_back(one.id + ": " + one.message);
    std::ranges::move(outcome.incomplete, std::back_inserter(finished.warnings));
    std::ranges::move(outcome.notes, std::back_inserter(finished.warnings));
    std::ranges::move(cache.warnings(), std::back_inserter(finished.warnings));
  });
  return finished;
}

}  // namespace

}  // namespace shapegauge

PYBIND11_MODULE(_native, module) {
  using namespace shapegauge;
  module.doc() = "Native functions of shapegauge; see the package.";
  static const py::exception<InputError> input_error(module, "InputError", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
      PyErr_SetString(input_error.ptr(), with_arguments(error.what()).c_str());
    }
  });
  module.def("with_arguments", &with_arguments);
  bind_shapes(module);
  bind_check(module);
  bind_evaluation(module);
  bind_comparison(module);
  bind_search(module);
  bind_settings(module);
  module.def("fuse", &fuse);
  module.def("rerank", &rerank);
  py::class_<FinishedRun>(module, "FinishedRun")
      .def_readonly("summary", &FinishedRun::summary)
      .def_readonly("warnings", &FinishedRun::warnings)
      .def_readonly("left_out", &FinishedRun::left_out);
  module.def("run", &run_configuration);
  module.def("file_safe_name", &file_safe_name);
  module.def("version", &version);
}
