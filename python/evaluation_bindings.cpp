// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of matrices and comparison of methods.
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/native.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/datasets/layouts/labels.h"
#include "shapegauge/experiments/cache/codec.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/results/method_comparison_tables.h"
#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/evaluators.h"
#include "shapegauge/metrics/matrix_checks.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/feature_checks.h"

namespace py = pybind11;

namespace shapegauge {

namespace {

/// Rows and columns of a matrix, and options of its evaluation.
struct EvaluationRequest {
  std::vector<int> labels;                   ///< of the rows; negative for no class
  std::vector<int> targets;                  ///< of the columns, if they are other models; otherwise empty
  std::vector<int> subclasses;               ///< of the models, see number_subclasses(); empty for none
  std::optional<Eigen::MatrixXi> relevance;  ///< grades instead of classes; 0: not relevant, negative: not judged
  bool square = true;                        ///< row i and column i are the same model
  bool negated = false;                      ///< the values are similarities
  EvaluationOptions options;
};

EvaluationOptions options_of(const std::string& protocol, const std::string& ties,
                             const std::vector<std::string>& measures, int minimum_class_size, const std::string& curve,
                             const std::string& evaluator) {
  if (!evaluator.empty()) return options_of_evaluator(evaluator);
  EvaluationOptions options;
  options.protocol = known_word<Protocol>("protocol", protocol);
  options.ties = known_word<Ties>("ties", ties);
  if (!curve.empty()) options.curve = known_word<CurveKind>("curve", curve);
  options.measures = measures_of(measures);
  options.minimum_class_size = minimum_class_size;
  return options;
}

int class_or_none(int label) { return label < 0 ? no_class : label; }

/// Makes the task with every model as a query to all others, or with rows as queries to columns. A model with a
/// negative label has no class: it is not a query, and relevant to none.
RetrievalTask task_of(const EvaluationRequest& request) {
  RetrievalTask task = leave_one_out(request.labels);
  std::ranges::transform(request.labels, task.query_classes.begin(), class_or_none);
  if (!request.square) {
    task.target_classes.clear();
    std::ranges::transform(request.targets, std::back_inserter(task.target_classes), class_or_none);
    task.own_column.assign(request.labels.size(), -1);
  }
  task.query_subclasses = task.target_subclasses = request.subclasses;
  if (!request.relevance) return task;
  const Eigen::MatrixXi& grades = *request.relevance;
  task.judged.resize(request.labels.size());
  task.grades.resize(request.labels.size());
  const bool all_judged = (grades.array() >= 0).all();
  if (!all_judged) task.judged_irrelevant.resize(request.labels.size());
  for (Eigen::Index i = 0; i < grades.rows(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < grades.cols(); ++j) {
      if (j == task.own_column[row]) continue;
      if (grades(i, j) > 0) {
        task.judged[row].push_back(j);
        task.grades[row].push_back(grades(i, j));
      } else if (grades(i, j) == 0 && !all_judged) {
        task.judged_irrelevant[row].push_back(j);
      }
    }
    const bool judged = all_judged || !task.judged[row].empty() || !task.judged_irrelevant[row].empty();
    if (!judged) task.query_classes[row] = no_class;
  }
  return task;
}

/// Evaluation with warnings about the matrix.
struct EvaluatedMatrix {
  std::shared_ptr<Evaluation> evaluation;
  std::vector<std::string> warnings;
};

EvaluatedMatrix evaluate_matrix(const Eigen::Ref<const DistanceMatrix>& distances, const EvaluationRequest& request,
                                int threads) {
  return compute(threads, [&] {
    MatrixChecks checks(request.square);
    const RowSource rows = [&](Eigen::Index first, Eigen::Index count) -> DistanceMatrix {
      DistanceMatrix some = distances.middleRows(first, count);
      checks.add(some);
      if (request.square) {
        checks.compare(some, first, distances.block(first, first, distances.rows() - first, count));
      }
      return some;
    };
    const RetrievalTask task = task_of(request);
    EvaluatedMatrix result;
    result.evaluation = std::make_shared<Evaluation>(evaluate(rows, task, request.options));
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < request.labels.size(); ++i) ids.push_back(std::to_string(i));
    const MatrixFindings found = checks.findings();
    result.warnings = matrix_warnings(found, ids, request.negated);
    for (const auto& warning : {chance_warning(*result.evaluation, found, task),
                                left_out_warning(*result.evaluation, task, request.options)}) {
      if (warning) result.warnings.push_back(*warning);
    }
    if (const auto tied = ties_warning(*result.evaluation, found)) {
      result.warnings.push_back(*tied);
    }
    return result;
  });
}

/// Returns low and high ends by measure, of the averages over queries and over classes; empty for too few units.
py::tuple intervals(const Evaluation& evaluation, double confidence, const std::string& blocks, int resamples,
                    std::uint64_t seed, int threads) {
  const auto unit = known_word<ResamplingUnit>("blocks", blocks);
  const EvaluationIntervals found = compute(threads, [&] {
    return intervals_of(
        evaluation, {.confidence = confidence, .blocks = unit, .resampling = {.resamples = resamples, .seed = seed}});
  });
  const auto ends = [](const std::vector<ConfidenceInterval>& of_measures) {
    std::vector<std::pair<double, double>> pairs;
    for (const ConfidenceInterval& one : of_measures) pairs.emplace_back(one.low, one.high);
    return pairs;
  };
  return py::make_tuple(ends(found.micro), ends(found.macro));
}

py::object pickled(const Evaluation& evaluation) { return py::bytes(encode(evaluation)); }

Evaluation unpickled(const py::object& state) {
  try {
    return decode<Evaluation>(py::isinstance<py::bytes>(state) ? state.cast<std::string>() : "");
  } catch (const DamagedBytes&) {
    throw InputError("the pickled scores are of another version of shapegauge; evaluate again");
  }
}

/// Comparison of methods, as by the command `compare`.
struct ComparedMethods {
  AlignedMethods methods;
  std::vector<MethodComparison> comparisons;
  ComparisonOptions options;

  [[nodiscard]] std::vector<std::string> warnings() const {
    const auto few = few_units_warning(comparisons.front(), options);
    return few ? std::vector{*few} : std::vector<std::string>();
  }
};

ComparedMethods compare_evaluations(const std::vector<std::string>& names,
                                    const std::vector<std::shared_ptr<Evaluation>>& evaluations,
                                    const std::string& test, const std::string& blocks, double confidence,
                                    int resamples, std::uint64_t seed, int threads) {
  return compute(threads, [&] {
    ComparedMethods compared;
    const Evaluation& first = *evaluations.at(0);
    compared.methods = {.methods = names,
                        .protocol = name_of(first.protocol),
                        .measures = first.measures,
                        .classes = first.query_classes};
    compared.options.test = known_word<PairTest>("test", test);
    compared.options.blocks = known_word<ResamplingUnit>("blocks", blocks);
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

void bind_evaluation_class(py::module_& module) {
  py::class_<Evaluation, std::shared_ptr<Evaluation>>(module, "Evaluation")
      .def_readonly("measures", &Evaluation::measures)
      .def_readonly("queries", &Evaluation::queries)
      .def_readonly("query_classes", &Evaluation::query_classes)
      .def_readonly("classes", &Evaluation::classes)
      .def_readonly("micro", &Evaluation::micro)
      .def_readonly("macro", &Evaluation::macro)
      .def_readonly("per_query", &Evaluation::per_query)
      .def_readonly("per_class", &Evaluation::per_class)
      .def_readonly("models_left_out", &Evaluation::excluded_models)
      .def_readonly("queries_with_ties", &Evaluation::queries_with_ties)
      .def_property_readonly("protocol", [](const Evaluation& evaluation) { return name_of(evaluation.protocol); })
      .def_property_readonly("recall", [](const Evaluation& evaluation) { return evaluation.micro_curve.recall; })
      .def_property_readonly("precision", [](const Evaluation& evaluation) { return evaluation.micro_curve.precision; })
      .def("table",
           [](const Evaluation& evaluation, const std::string& method, const std::string& format) {
             const std::vector<NamedEvaluation> one{{.method = method, .evaluation = &evaluation}};
             return table_text(summary_table(one), value_of_word<TableFormat>(format).value());
           })
      .def(py::pickle(&pickled, &unpickled));
}

}  // namespace

void bind_evaluation(py::module_& module) {
  module.attr("missing_value_words") =
      py::cast(std::vector<std::string>(missing_value_words.begin(), missing_value_words.end()));
  bind_evaluation_class(module);
  module.def("evaluate", [](const Eigen::Ref<const DistanceMatrix>& distances, const std::vector<int>& labels,
                            const std::optional<std::vector<int>>& targets, const std::vector<int>& subclasses,
                            const std::optional<Eigen::MatrixXi>& relevance, const std::string& protocol,
                            const std::string& ties, const std::vector<std::string>& measures, const std::string& curve,
                            int minimum_class_size, const std::string& evaluator, bool negated, int threads) {
    const EvaluationRequest request{
        .labels = labels,
        .targets = targets.value_or(std::vector<int>()),
        .subclasses = subclasses,
        .relevance = relevance,
        .square = !targets,
        .negated = negated,
        .options = options_of(protocol, ties, measures, minimum_class_size, curve, evaluator)};
    const EvaluatedMatrix evaluated = evaluate_matrix(distances, request, threads);
    return py::make_tuple(evaluated.evaluation, evaluated.warnings);
  });
  module.def("intervals", &intervals);
  module.def("feature_distances",
             [](const Eigen::Ref<const Signatures>& features, const std::string& distance, int threads) {
               return array_of(compute(threads, [&] { return feature_distances(distance, features); }));
             });
  module.def("check_features",
             [](const Eigen::Ref<const DistanceMatrix>& features) { return check_features(features); });
}

void bind_comparison(py::module_& module) {
  py::class_<ComparedMethods>(module, "ComparedMethods")
      .def("json",
           [](const ComparedMethods& compared) {
             return comparison_json(compared.methods, compared.comparisons, compared.options).dump();
           })
      .def_property_readonly("warnings", &ComparedMethods::warnings)
      .def("summary",
           [](const ComparedMethods& compared, const std::string& format) {
             return table_text(comparison_summary(compared.methods, compared.comparisons, compared.options, {}),
                               value_of_word<TableFormat>(format).value());
           })
      .def("pairs", [](const ComparedMethods& compared, const std::string& format) {
        return table_text(pairs_table(compared.methods, compared.comparisons, {}, format == "csv"),
                          value_of_word<TableFormat>(format).value());
      });
  module.def("compare", &compare_evaluations);
}

}  // namespace shapegauge
