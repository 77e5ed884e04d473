// The native half of the Python package: arrays in, arrays out. What is comfortable about the package is Python and
// stands in shapegauge/__init__.py.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/results/method_comparison_tables.h"
#include "shapegauge/experiments/results/result_folder.h"
#include "shapegauge/experiments/results/write_results.h"
#include "shapegauge/experiments/runner/run_comparison.h"
#include "shapegauge/experiments/runner/run_experiment.h"
#include "shapegauge/experiments/runner/run_warnings.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/matrix_checks.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/retrieval/rerank.h"

namespace py = pybind11;

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Whether a signal (Ctrl-C) waits for the interpreter, whose handler then raises. Only its main thread sees one.
bool signal_waits() {
  const py::gil_scoped_acquire acquired;
  return PyErr_CheckSignals() != 0;
}

/// Does the work without the interpreter's lock, on at most so many threads (0: all).
template <typename Work>
auto compute(int threads, const Work& work) {
  const py::gil_scoped_release released;
  std::optional<decltype(work())> result;
  with_threads(threads, [&] { result.emplace(work()); });
  return std::move(*result);
}

/// A NumPy array that owns the matrix: nothing is copied.
template <typename Matrix>
py::array array_of(Matrix&& matrix) {
  auto owned = std::make_unique<std::decay_t<Matrix>>(std::forward<Matrix>(matrix));
  const auto* values = owned.get();
  const py::capsule owner(owned.release(), [](void* pointer) { delete static_cast<std::decay_t<Matrix>*>(pointer); });
  using Scalar = typename std::decay_t<Matrix>::Scalar;
  if constexpr (std::decay_t<Matrix>::ColsAtCompileTime == 1) {
    return py::array_t<Scalar>({values->rows()}, {sizeof(Scalar)}, values->data(), owner);
  } else {
    const std::size_t row = std::decay_t<Matrix>::IsRowMajor ? static_cast<std::size_t>(values->cols()) : 1;
    const std::size_t column = std::decay_t<Matrix>::IsRowMajor ? 1 : static_cast<std::size_t>(values->rows());
    return py::array_t<Scalar>({values->rows(), values->cols()}, {row * sizeof(Scalar), column * sizeof(Scalar)},
                               values->data(), owner);
  }
}

Shape shape_of(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
               const Eigen::Ref<const Points>& normals) {
  Shape shape{.vertices = vertices, .triangles = faces, .normals = normals};
  require_usable(shape);
  return shape;
}

py::tuple field(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
                const Eigen::Ref<const Points>& normals, const std::string& settings, int threads) {
  struct Computed {
    Samples samples;
    FieldValues values;
  };
  Computed computed = compute(threads, [&] {
    const Json json = Json::parse(settings);
    check_against_schema(json, "field", "the field");
    const Field wanted = make_field(json);
    const Shape shape = shape_of(vertices, faces, normals);
    Samples samples = take_samples(shape, wanted.samples);
    FieldSource source(shape);
    FieldValues values = wanted.compute(source, samples, true);
    return Computed{std::move(samples), std::move(values)};
  });
  const py::object offset = py::cast(computed.values.offset);
  const py::object warnings = py::cast(outcome_warnings(computed.values.outcomes));
  return py::make_tuple(array_of(std::move(computed.values.values)), array_of(std::move(computed.samples.weights)),
                        array_of(std::move(computed.values.normals)), warnings, offset);
}

py::array segment(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
                  const Eigen::Ref<const Points>& normals, const std::string& settings, int threads) {
  return array_of(compute(threads, [&] {
    const Json json = Json::parse(settings);
    check_against_schema(json, "segmentation_method", "the segmentation");
    if (json.contains("perturbations")) throw InputError("perturbations are of an experiment: use run()");
    const SegmentationMethod method = segmentation_method(json);
    const std::vector<std::int32_t> labels = segmented(shape_of(vertices, faces, normals), method);
    return Eigen::VectorX<std::int32_t>(
        Eigen::Map<const Eigen::VectorX<std::int32_t>>(labels.data(), static_cast<Eigen::Index>(labels.size())));
  }));
}

py::array describe(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
                   const Eigen::Ref<const Points>& normals, const std::string& settings, int threads) {
  return array_of(compute(threads, [&] {
    const Json json = Json::parse(settings);
    check_against_schema(json, "descriptor", "the descriptor");
    const DescriptorChoice choice = make_descriptor(json);
    if (learns(choice.descriptor, choice.values)) {
      throw InputError("the descriptor " + std::string(choice.descriptor.name) +
                       " learns from a whole data set: describe one by a configuration, with run()");
    }
    const Shape shape = prepare_shape(shape_of(vertices, faces, normals), {}).shape;
    const std::vector<ScalarField> fields = compute_fields(choice, shape);
    return compute_features(choice.descriptor, {.shape = shape, .fields = fields}, {}, choice.values);
  }));
}

EvaluationOptions options_of(const std::string& protocol, const std::string& ties,
                             const std::vector<std::string>& measures, int minimum_class_size) {
  EvaluationOptions options;
  const auto known_protocol = protocol_of(protocol);
  if (!known_protocol) throw InputError("there is no protocol \"" + protocol + "\"; there are psb, paper and trec");
  const auto known_ties = ties_of(ties);
  if (!known_ties) {
    throw InputError("there are no ties \"" + ties + "\"; there are index, optimistic, pessimistic and expected");
  }
  options.protocol = *known_protocol;
  options.ties = *known_ties;
  options.measures = measures_of(measures);
  options.minimum_class_size = minimum_class_size;
  return options;
}

/// The evaluation and what is odd about the matrix.
std::pair<std::shared_ptr<Evaluation>, std::vector<std::string>> evaluate_matrix(
    const Eigen::Ref<const DistanceMatrix>& distances, const std::vector<int>& labels, const EvaluationOptions& options,
    int threads) {
  bool interrupted = false;
  auto result = compute(threads, [&] {
    MatrixChecks checks(true);
    const DistanceRows rows = [&](Eigen::Index first, Eigen::Index count) -> DistanceTableRows {
      interrupted = interrupted || signal_waits();
      if (interrupted) throw Interrupted();
      DistanceTableRows some = distances.middleRows(first, count);
      checks.add(some);
      checks.compare(some, first, distances.block(first, first, distances.rows() - first, count));
      return some;
    };
    if (distances.rows() != distances.cols() || static_cast<std::size_t>(distances.rows()) != labels.size()) {
      throw InputError("the distances are " + std::to_string(distances.rows()) + " x " +
                       std::to_string(distances.cols()) + ", the labels " + std::to_string(labels.size()) +
                       ": they must be as many, a row and a column for each");
    }
    auto evaluation = std::make_shared<Evaluation>(evaluate(rows, leave_one_out(labels), options));
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < labels.size(); ++i) ids.push_back(std::to_string(i));
    return std::pair(std::move(evaluation), matrix_warnings(checks.findings(), ids, false));
  });
  return result;
}

std::string formatted(const Table& table, const std::string& format) {
  if (format == "latex") return to_latex(table);
  if (format == "markdown") return to_markdown(table);
  return format == "csv" ? to_csv(table) : to_plain_text(table);
}

void bind_evaluation(py::module_& module) {
  py::class_<Evaluation, std::shared_ptr<Evaluation>>(module, "Evaluation")
      .def_readonly("measures", &Evaluation::measures)
      .def_readonly("queries", &Evaluation::queries)
      .def_readonly("query_classes", &Evaluation::query_classes)
      .def_readonly("classes", &Evaluation::classes)
      .def_readonly("micro", &Evaluation::micro)
      .def_readonly("macro", &Evaluation::macro)
      .def_readonly("per_query", &Evaluation::per_query)
      .def_readonly("per_class", &Evaluation::per_class)
      .def_readonly("models_left_out", &Evaluation::models_left_out)
      .def_readonly("queries_with_ties", &Evaluation::queries_with_ties)
      .def_property_readonly("protocol", [](const Evaluation& evaluation) { return name_of(evaluation.protocol); })
      .def_property_readonly("recall", [](const Evaluation& evaluation) { return evaluation.micro_curve.recall; })
      .def_property_readonly("precision", [](const Evaluation& evaluation) { return evaluation.micro_curve.precision; })
      .def("table", [](const Evaluation& evaluation, const std::string& method, const std::string& format) {
        const std::vector<NamedEvaluation> one{{.method = method, .evaluation = &evaluation}};
        return formatted(summary_table(one), format);
      });
  module.def("evaluate", [](const Eigen::Ref<const DistanceMatrix>& distances, const std::vector<int>& labels,
                            const std::string& protocol, const std::string& ties,
                            const std::vector<std::string>& measures, int minimum_class_size, int threads) {
    return evaluate_matrix(distances, labels, options_of(protocol, ties, measures, minimum_class_size), threads);
  });
}

/// Methods side by side, as the command `compare` has them.
struct ComparedMethods {
  AlignedMethods methods;
  std::vector<MethodComparison> comparisons;
  ComparisonOptions options;
};

ComparedMethods compare_evaluations(const std::vector<std::string>& names,
                                    const std::vector<std::shared_ptr<Evaluation>>& evaluations,
                                    const std::string& test, double confidence, int resamples, std::uint64_t seed,
                                    int threads) {
  return compute(threads, [&] {
    ComparedMethods compared;
    const Evaluation& first = *evaluations.at(0);
    compared.methods = {.methods = names,
                        .protocol = name_of(first.protocol),
                        .measures = first.measures,
                        .classes = first.query_classes,
                        .values = {}};
    const auto known = pair_test_of(test);
    if (!known) throw InputError("there is no test \"" + test + "\"; there are randomization, t and bootstrap");
    compared.options.test = *known;
    compared.options.confidence = confidence;
    compared.options.resampling = {.resamples = resamples, .seed = seed};
    for (Eigen::Index k = 0; k < first.per_query.cols(); ++k) {
      Eigen::MatrixXd values(first.per_query.rows(), static_cast<Eigen::Index>(evaluations.size()));
      for (std::size_t method = 0; method < evaluations.size(); ++method) {
        values.col(static_cast<Eigen::Index>(method)) = evaluations[method]->per_query.col(k);
      }
      compared.comparisons.push_back(compare_methods(values, first.query_classes, compared.options));
      compared.methods.values.push_back(std::move(values));
    }
    return compared;
  });
}

void bind_comparison(py::module_& module) {
  py::class_<ComparedMethods>(module, "ComparedMethods")
      .def("json",
           [](const ComparedMethods& compared) {
             return comparison_json(compared.methods, compared.comparisons, compared.options).dump();
           })
      .def("summary",
           [](const ComparedMethods& compared, const std::string& format) {
             return formatted(comparison_summary(compared.methods, compared.comparisons, compared.options, {}), format);
           })
      .def("pairs", [](const ComparedMethods& compared, const std::string& format) {
        return formatted(pairs_table(compared.methods, compared.comparisons, {}, format == "csv"), format);
      });
  module.def("compare", &compare_evaluations);
}

py::array rerank(const Eigen::Ref<const DistanceMatrix>& distances, const std::string& method,
                 const std::string& settings, int threads) {
  return array_of(compute(threads, [&] {
    const RerankMethod& chosen = rerank_method(method);
    const Json json = Json::parse(settings);
    for (const auto& [name, value] : json.items()) {
      if (std::ranges::find(chosen.parameters, name, &Parameter::name) == chosen.parameters.end()) {
        throw InputError("the method " + method + " has no setting \"" + name + "\"");
      }
    }
    return chosen.rerank(distances, read_parameters(chosen.parameters, json));
  }));
}

/// What became of a run.
struct FinishedRun {
  std::string summary;
  std::vector<std::string> warnings;
  std::vector<std::string> left_out;
};

FinishedRun run_configuration(const fs::path& configuration, const std::vector<std::string>& overrides,
                              const fs::path& output, bool replace, const std::optional<fs::path>& cache_folder,
                              int threads) {
  const py::gil_scoped_release released;
  const Json document = read_configuration_document(configuration, overrides);
  const RunControl control{.threads = threads, .interrupted = signal_waits};
  FinishedRun finished;
  const FolderLock lock(output);
  if (is_comparison(document)) {
    const Comparison comparison = comparison_from_json(document, configuration.string(), configuration.parent_path());
    prepare_result_folder(output, to_json(comparison), replace);
    const ComparisonResults results = run_comparison(comparison, control);
    write_comparison(output, results);
    finished = {.summary = summary_text(results), .warnings = field_warnings(results.fields), .left_out = {}};
    for (const FailedShape& failure : results.failures) {
      finished.left_out.push_back(failure.name + ": " + failure.message);
    }
    return finished;
  }
  const Configuration experiment =
      configuration_from_json(document, configuration.string(), configuration.parent_path());
  prepare_result_folder(output, to_json(experiment), replace);
  Cache cache(cache_folder.value_or(default_cache_folder()), false);
  const ExperimentResults results = run_into_folder(output, experiment, control, cache, *single_process());
  if (!cache.folder().empty()) trim_cache(cache.folder(), cache_limit());
  finished = {.summary = summary_text(results), .warnings = run_warnings(results), .left_out = {}};
  for (const FailedModel& failure : results.failures) {
    finished.left_out.push_back(failure.model.id + ": " + failure.message);
  }
  return finished;
}

void bind_shapes(py::module_& module) {
  module.def("read", [](const fs::path& path) {
    Shape shape = [&] {
      const py::gil_scoped_release released;
      return read_shape(path);
    }();
    return py::make_tuple(array_of(std::move(shape.vertices)), array_of(std::move(shape.triangles)),
                          array_of(std::move(shape.normals)));
  });
  module.def("write", [](const fs::path& path, const Eigen::Ref<const Points>& vertices,
                         const Eigen::Ref<const Triangles>& faces, const Eigen::Ref<const Points>& normals) {
    const py::gil_scoped_release released;
    shape_writer(path)(path, shape_of(vertices, faces, normals));
  });
  module.def("field", &field);
  module.def("segment", &segment);
  module.def("describe", &describe);
}

}  // namespace

}  // namespace shapegauge

PYBIND11_MODULE(_native, module) {
  using namespace shapegauge;
  module.doc() = "Native functions of shapegauge; see the package.";
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const ConfigurationError& error) {
      PyErr_SetString(PyExc_ValueError, (error.path + ": " + error.message).c_str());
    } catch (const Interrupted& error) {
      // The interpreter's own handler has raised already, if it is the usual one.
      if (PyErr_Occurred() == nullptr) PyErr_SetString(PyExc_KeyboardInterrupt, error.what());
    }
  });
  bind_shapes(module);
  bind_evaluation(module);
  bind_comparison(module);
  module.def("rerank", &rerank);
  py::class_<FinishedRun>(module, "FinishedRun")
      .def_readonly("summary", &FinishedRun::summary)
      .def_readonly("warnings", &FinishedRun::warnings)
      .def_readonly("left_out", &FinishedRun::left_out);
  module.def("run", &run_configuration);
  module.def("version", &version);
}
