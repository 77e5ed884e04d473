// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/segmentation/run_segmentation.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/members.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/engine/generated_dataset.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/experiments/signatures/model_view.h"
#include "shapegauge/pages/coarse_view.h"
#include "shapegauge/segmentation/paper_segmentation.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/segment_labels.h"

namespace shapegauge {

namespace {

using Labels = std::vector<std::int32_t>;

constexpr int picture_width = 160;
constexpr int picture_height = 128;

/// Returns the parts' fractions of the area, largest first.
std::vector<double> part_sizes(const Labels& labels, const Eigen::VectorXd& areas) {
  std::vector<double> sizes(static_cast<std::size_t>(*std::ranges::max_element(labels)) + 1, 0);
  const double area = areas.sum();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    sizes[static_cast<std::size_t>(labels[i])] += areas[static_cast<Eigen::Index>(i)] / area;
  }
  std::ranges::sort(sizes, std::greater<>{});
  return sizes;
}

/// Transfers labels of a perturbed mesh, or of a cloud made from it, to the original mesh: each triangle gets the label
/// of the nearest centroid. With equal numbers of triangles, they correspond by index.
Labels carried_over(const Labels& labels, const Shape& changed, const Shape& mesh) {
  if (!is_cloud(changed) && changed.triangles.rows() == mesh.triangles.rows()) return labels;
  const SampleSite site = is_cloud(changed) ? SampleSite::vertices : SampleSite::faces;
  Labels carried;
  for (const std::int32_t i :
       nearest_points(sample_shape(mesh, SampleSite::faces).points, sample_shape(changed, site).points)) {
    carried.push_back(labels[static_cast<std::size_t>(i)]);
  }
  return carried;
}

/// Parts of one shape by one method.
struct Parts {
  Labels labels;
  std::vector<std::string> remarks = {};   ///< of the perturbations
  std::vector<std::string> warnings = {};  ///< of the offset SDF
};

SHAPEGAUGE_MEMBERS(Parts, labels, remarks, warnings)

/// Segmentation of one shape, with its inputs and results.
class SegmentationJob {
 public:
  /// Finds the parts by all methods. `index` is the model's index in the data set, which perturbations may depend on.
  SegmentationJob(const SegmentationExperiment& experiment, const SegmentedModel& model, std::size_t index,
                  Cache& cache)
      : experiment_(experiment), model_(model), index_(index), cache_(cache) {
    const ShapeSource source = read_shape_source(model.mesh);
    mesh_ = read_shape(source);
    result.mesh_sha256 = sha256_of_shape(source);
    result.has_polygons = has_polygons(mesh_);
    for (const std::filesystem::path& file : model.people) {
      people_.push_back(read_seg(file, mesh_));
      result.people_sha256.push_back(sha256_of_file(file));
    }
    for (const SegmentationMethod& method : experiment.methods) {
      const Parts& parts = cached_parts(method);
      result.labels.push_back(parts.labels);
      for (const std::string& remark : parts.remarks) result.remarks.push_back(method.name + ": " + remark);
      for (const std::string& warning : parts.warnings) result.warnings.push_back(method.name + ": " + warning);
      if (!method.perturbations.empty()) (void)cached_parts(without_perturbations(method));
    }
  }

  /// Evaluates the parts and draws them. `view_faces` is the number of faces of an interactive view; 0: without one.
  void evaluate(Eigen::Index view_faces) {
    const SegmentationScorer scorer(mesh_, {.by = experiment_.by, .cuts = experiment_.cuts});
    for (const Labels& labels : result.labels) errors.push_back(scorer.mean_errors_against(labels, people_));
    errors.push_back(scorer.mean_errors_among(people_));
    const Eigen::VectorXd areas = sample_shape(mesh_, SampleSite::faces).weights;
    for (const Labels& labels : result.labels) result.part_sizes.push_back(part_sizes(labels, areas));
    for (std::size_t m = 0; m < result.labels.size(); ++m)
      result.perturbation_errors.push_back(perturbation_error(m, scorer));
    if (experiment_.pictures) draw(view_faces);
    for (Labels& labels : result.labels) labels = labels_of_polygons(mesh_, labels);
  }

  SegmentedShape result;
  std::vector<SegmentationErrors> errors;  ///< per method, then people's

 private:
  const Parts& cached_parts(const SegmentationMethod& method) {
    const std::string key =
        segmentation_key({.sha256 = result.mesh_sha256, .file = model_.mesh, .id = model_.id, .index = index_}, method,
                         versions_of(method), experiment_);
    // Several methods may need the same undamaged parts, possibly without a cache.
    const auto done = done_.find(key);
    if (done != done_.end()) return done->second;
    return done_[key] = cache_.get(EntryKind::segmentation, key, [&] { return computed_parts(method); });
  }

  static SegmentationMethod without_perturbations(SegmentationMethod method) {
    method.perturbations.clear();
    return method;
  }

  [[nodiscard]] Parts computed_parts(const SegmentationMethod& method) const {
    if (method.perturbations.empty()) return parts_of(mesh_, method);
    PerturbedShape changed = perturb_model(mesh_, method.perturbations, experiment_.seed, model_.id, index_);
    Parts parts = parts_of(changed.shape, method);
    parts.labels = renumber_labels(carried_over(parts.labels, changed.shape, mesh_));
    parts.remarks = std::move(changed.remarks);
    return parts;
  }

  [[nodiscard]] Parts parts_of(const Shape& shape, const SegmentationMethod& method) const {
    OffsetSdfOutcomes outcomes;
    Parts parts{.labels = segment_shape(prepared(shape), method.options, &outcomes)};
    parts.warnings = outcome_warnings(field_outcomes(outcomes));
    return parts;
  }

  /// Prepares a shape. The default preparation only scales, on which parts do not depend.
  [[nodiscard]] Shape prepared(const Shape& shape) const {
    return experiment_.preparation == PreparationOptions() ? shape
                                                           : prepare_shape(shape, experiment_.preparation).shape;
  }

  /// Measures how much the perturbations of a method change its parts.
  double perturbation_error(std::size_t method, const SegmentationScorer& scorer) {
    const SegmentationMethod& perturbed = experiment_.methods[method];
    if (perturbed.perturbations.empty()) return std::numeric_limits<double>::quiet_NaN();
    return scorer.errors(result.labels[method], cached_parts(without_perturbations(perturbed)).labels).rand_index;
  }

  void draw(Eigen::Index view_faces) {
    const Eigen::Vector3d up = up_direction(experiment_.up, model_.mesh);
    ShapeView view{.name = "", .shape = mesh_, .up = up};
    const SurfaceGraph graph = surface_graph(mesh_);
    const auto add = [&](const std::string& name, const Labels& labels) {
      const Labels numbers = renumber_labels(labels);
      const std::vector<Colour> colours = colour_of_each_label(graph, numbers);
      result.pictures.push_back(picture(numbers, colours, up));
      view.parts.push_back({.name = name, .labels = numbers, .colours = colours});
    };
    if (!people_.empty()) add(reference_name(experiment_), people_.front());
    for (std::size_t m = 0; m < result.labels.size(); ++m) add(experiment_.methods[m].name, result.labels[m]);
    if (view_faces == 0) return;
    const Samples samples = sample_shape(mesh_, view.site);
    result.view = json_text(shape_view_json(coarse_view(std::move(view), samples, view_faces)));
  }

  [[nodiscard]] std::string picture(const Labels& labels, const std::vector<Colour>& colours,
                                    const Eigen::Vector3d& up) const {
    const RenderOptions options{.width = picture_width, .height = picture_height, .up = up, .transparent = true};
    std::vector<Colour> of_faces;
    for (const std::int32_t label : labels) of_faces.push_back(colours[static_cast<std::size_t>(label)]);
    return encode_png(render_shape(mesh_, of_faces, SampleSite::faces, upright_view(mesh_, options)));
  }

  const SegmentationExperiment& experiment_;
  const SegmentedModel& model_;
  std::size_t index_;
  Cache& cache_;
  Shape mesh_;
  std::vector<Labels> people_;
  std::map<std::string, Parts> done_;  ///< by key of the cache
};

/// Makes a benchmark without human segmentations.
SegmentationBenchmark without_people(const Dataset& dataset) {
  SegmentationBenchmark shapes{
      .models = {}, .classes = dataset.classes, .without_people = {}, .skipped = dataset.skipped};
  for (const Model& model : dataset.models) {
    shapes.models.push_back({.id = model.id, .mesh = model.file, .people = {}, .label = model.label});
  }
  return shapes;
}

SegmentationBenchmark benchmark_of(const SegmentationExperiment& experiment, const RunContext& context) {
  if (!experiment.generator) return find_segmented_shapes(experiment.location);
  prepare_generated(context.generated, *experiment.generator, context.control);
  return find_generated_parts(context.generated);
}

std::vector<std::string> method_names(const SegmentationExperiment& experiment,
                                      const SegmentationBenchmark& benchmark) {
  std::vector<std::string> names;
  for (const SegmentationMethod& method : experiment.methods) names.push_back(method.name);
  const bool several = std::ranges::all_of(benchmark.models, [](const auto& model) { return model.people.size() > 1; });
  if (several) names.emplace_back(people_name);
  return names;
}

/// Removes failed shapes from the benchmark; returns the old indices of the others.
std::vector<std::size_t> split_failures(const std::vector<ModelFailure>& failed, SegmentationResults& results) {
  std::vector<SegmentedModel> used;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < results.benchmark.models.size(); ++i) {
    const auto failure = std::ranges::find(failed, i, &ModelFailure::model);
    if (failure == failed.end()) {
      left.push_back(i);
      used.push_back(results.benchmark.models[i]);
    } else {
      results.failures.push_back({.id = results.benchmark.models[i].id, .message = failure->message});
      results.failed.push_back(results.benchmark.models[i]);
    }
  }
  results.benchmark.models = std::move(used);
  return left;
}

void check_failures(const std::vector<ModelFailure>& failed, const SegmentationExperiment& experiment,
                    const SegmentationBenchmark& benchmark) {
  if (failed.empty()) return;
  const std::string first =
      fmt::format("shape {}: {}", benchmark.models[failed.front().model].id, failed.front().message);
  if (experiment.on_error == OnError::stop) {
    throw InputError(first + R"(; repair or remove it, or set "on_error" to "skip")");
  }
  if (failed.size() == benchmark.models.size()) throw InputError("no shape can be used; the first one, " + first);
}

/// Results for a shape.
struct CutShape {
  SegmentedShape shape;
  std::vector<SegmentationErrors> errors;  ///< per method, then people's
};

void run_stages(const RunContext& context, SegmentationResults& results) {
  const Stopwatch stopwatch;
  results.benchmark = benchmark_of(results.experiment, context);
  results.classification_sha256 = sha256_of_file_if_readable(results.experiment.location.classification);
  results.has_people =
      std::ranges::any_of(results.benchmark.models, [](const SegmentedModel& model) { return !model.people.empty(); });
  std::vector<std::size_t> all(results.benchmark.models.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::map<std::size_t, CutShape> cut;
  std::mutex mutex;
  const bool stop = results.experiment.on_error == OnError::stop;
  const Eigen::Index view_faces = all.size() <= max_models_with_views ? faces_of_views(all.size()) : 0;
  const std::vector<ModelFailure> failed = for_each_model(all, "shapes", stop, context.control, [&](std::size_t i) {
    SegmentationJob job(results.experiment, results.benchmark.models[i], i, context.cache);
    job.evaluate(view_faces);
    const std::scoped_lock lock(mutex);
    cut.emplace(i, CutShape{.shape = std::move(job.result), .errors = std::move(job.errors)});
  });
  check_failures(failed, results.experiment, results.benchmark);
  const std::vector<std::size_t> left = split_failures(failed, results);
  results.scores = empty_scores(results.benchmark, method_names(results.experiment, results.benchmark));
  for (std::size_t k = 0; k < left.size(); ++k) {
    for (std::size_t m = 0; m < results.scores.methods.size(); ++m)
      results.scores.errors[m][k] = cut.at(left[k]).errors[m];
    results.shapes.push_back(std::move(cut.at(left[k]).shape));
  }
  results.timings.emplace_back("shapes", stopwatch.seconds());
}

}  // namespace

std::string reference_name(const SegmentationExperiment& experiment) {
  return experiment.generator ? "reference" : "a person";
}

SegmentationBenchmark find_segmented_shapes(const DatasetLocation& location) {
  return location.layout == segmentation_layout ? find_segmentation_benchmark(location.root)
                                                : without_people(find_dataset(location));
}

nlohmann::json versions_of(const SegmentationMethod& method) {
  // The shape determines which diameter is used as thickness. Normals of clouds are those of the samples.
  nlohmann::json versions{{"cone_sdf", cone_sdf_version},
                          {"offset_sdf", offset_sdf_version},
                          {"automatic_offset", automatic_offset_version},
                          {"samples", samples_version}};
  if (method.options.method == SegmentationAlgorithm::paper) {
    versions["paper_segmentation"] = paper_segmentation_version;
  } else {
    versions["part_segmentation"] = part_segmentation_version;
    versions["part_model"] = part_model_version;
  }
  return versions;
}

SegmentationResults run_segmentation(const SegmentationExperiment& experiment, const RunContext& context) {
  SegmentationResults results;
  results.experiment = experiment;
  results.threads = thread_count(context.control);
  with_threads(context.control, [&] { run_stages(context, results); });
  results.cache = context.cache.report();
  return results;
}

PartOutcome run_part_of_segmentation(const SegmentationExperiment& experiment, const RunContext& context,
                                     const Part& part) {
  const SegmentationBenchmark benchmark = benchmark_of(experiment, context);
  std::vector<std::size_t> all(benchmark.models.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::size_t> shard = part.of(all);
  PartOutcome outcome{.all = all.size(), .noun = "shape"};
  with_threads(context.control, [&] {
    const bool stop = experiment.on_error == OnError::stop;
    const std::vector<ModelFailure> failed = for_each_model(shard, "shapes", stop, context.control, [&](std::size_t i) {
      const SegmentationJob job(experiment, benchmark.models[i], i, context.cache);
    });
    if (stop) check_failures(failed, experiment, benchmark);
    outcome.shapes = shard.size() - failed.size();
    for (const ModelFailure& failure : failed) {
      outcome.left_out.push_back({.id = benchmark.models[failure.model].id, .message = failure.message});
    }
  });
  return outcome;
}

}  // namespace shapegauge
