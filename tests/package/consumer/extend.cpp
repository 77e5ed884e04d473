// Adds one entry to each registry: a field, a descriptor, a perturbation, a distance, a measure, a file format, a
// layout of data sets, a re-ranking method and a kind of experiment.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/kinds/experiment_kinds.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "shapegauge/metrics/measures.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distances.h"
#include "shapegauge/retrieval/l1_distance.h"
#include "shapegauge/retrieval/rerank.h"

namespace {

void add_field() {
  shapegauge::field_types().add(
      {.name = "height",
       .description = "Height above the lowest vertex.",
       .parameters = {{.name = "factor", .default_value = 1.0, .description = "Factor applied to the heights."}},
       .make = [](const shapegauge::ParameterValues& settings, const shapegauge::SamplePlan& /*where*/) {
         const auto height = [factor = settings.number("factor")](shapegauge::FieldSource& source,
                                                                  const shapegauge::Samples& samples,
                                                                  bool /*parallel*/) {
           const double lowest = source.shape().vertices.col(2).minCoeff();
           return shapegauge::FieldValues{.values = factor * (samples.points.col(2).array() - lowest)};
         };
         return shapegauge::FieldComputation{.versions = {{"height", 1}}, .compute = height};
       }});
}

void add_descriptor() {
  shapegauge::descriptors().add(
      {.name = "extent",
       .description = "Side lengths of the bounding box.",
       .parameters = {},
       .describe =
           [](const shapegauge::DescriptorInput& input, const shapegauge::LearntFeatures& /*learnt*/,
              const shapegauge::DescriptorSettings& /*settings*/) {
             const auto& vertices = input.shape.vertices;
             return Eigen::VectorXf((vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).cast<float>());
           },
       .distance = shapegauge::l1_distance});
}

void add_perturbation() {
  static constexpr std::array parameters{shapegauge::Parameter{
      .name = "by", .default_value = 2.0, .bounds = {.low = 0.1, .high = 10}, .description = "Factor along z."}};
  shapegauge::shape_perturbations().add(
      {.name = "stretch",
       .description = "Stretches the shape along z.",
       .parameters = parameters,
       .apply = [](shapegauge::Shape shape, const shapegauge::ParameterValues& settings, shapegauge::RandomNumbers&) {
         shape.vertices.col(2) *= settings.number("by");
         return shape;
       }});
}

void add_distance() {
  shapegauge::distances().add({.name = "largest", .function = [](std::span<const float> a, std::span<const float> b) {
                                 double largest = 0;
                                 for (std::size_t i = 0; i < a.size(); ++i) {
                                   largest = std::max(largest, std::abs(double{a[i]} - double{b[i]}));
                                 }
                                 return largest;
                               }});
}

void add_measure() {
  shapegauge::measure_definitions().add({.name = "hit@k",
                                         .title = "Hit among the first k",
                                         .definition = "mean number of hits among the ranks 1 to k, at most 1",
                                         .source = "",
                                         .caveat = "",
                                         .value_at = [](const shapegauge::RankedList& list, std::size_t k) {
                                           return std::min(1.0, shapegauge::hits_among_first(list, k));
                                         }});
}

void add_file_format() {
  static constexpr std::array<std::string_view, 1> extensions{".points"};
  shapegauge::shape_formats().add({.name = "points",
                                   .description = "the coordinates of a point in each line",
                                   .extensions = extensions,
                                   .check_header = [](const std::string& /*bytes*/, const std::string& /*name*/) {},
                                   .read =
                                       [](const shapegauge::ShapeSource& source) {
                                         shapegauge::Shape cloud;
                                         std::istringstream text(source.bytes);
                                         for (double x = 0, y = 0, z = 0; text >> x >> y >> z;) {
                                           cloud.vertices.conservativeResize(cloud.vertices.rows() + 1,
                                                                             Eigen::NoChange);
                                           cloud.vertices.bottomRows<1>() << x, y, z;
                                         }
                                         return cloud;
                                       }});
}

void add_layout() {
  shapegauge::dataset_layouts().add(
      {.name = "flat",
       .find =
           [](const shapegauge::DatasetLocation& location) {
             shapegauge::Dataset dataset{.classes = {"all"}};
             for (const auto& entry : std::filesystem::directory_iterator(location.root)) {
               if (entry.path().extension() != ".points") continue;
               dataset.models.push_back({.id = entry.path().stem().string(), .file = entry.path(), .label = 0});
             }
             return dataset;
           },
       .default_classification = ""});
}

void add_rerank_method() {
  shapegauge::rerank_methods().add(
      {.name = "squares",
       .description = "The squares of the distances.",
       .parameters = {},
       .rerank = [](const shapegauge::DistanceMatrix& distances, const shapegauge::ParameterValues& /*settings*/)
           -> shapegauge::DistanceMatrix { return distances.cwiseAbs2(); }});
}

void add_experiment_kind() {
  shapegauge::experiment_kinds().add(
      {.name = "count",
       .description = "Number of models of a data set.",
       .keys = {"count"},
       .paths = {.files = {"/count"}},
       .schema =
           [] {
             return nlohmann::ordered_json{{"type", "object"},
                                           {"additionalProperties", false},
                                           {"properties", {{"count", {{"$ref", "#/definitions/dataset_root"}}}}}};
           },
       .read =
           [](const nlohmann::json& document, const std::string& /*source*/, const std::filesystem::path& folder) {
             const shapegauge::DatasetLocation dataset{.layout = "flat", .root = folder / document.at("count")};
             const auto run = [dataset](const shapegauge::RunContext& /*context*/, const shapegauge::RunResults& to) {
               shapegauge::RunOutcome outcome{.noun = "model"};
               outcome.used = shapegauge::find_dataset(dataset).models.size();
               outcome.summary = std::to_string(outcome.used) + " models";
               outcome.files = {"count.txt"};
               shapegauge::write_file_atomically(to.folder / "count.txt", outcome.summary + "\n");
               to.manifest["inputs"] = nlohmann::json::object();
               return outcome;
             };
             return shapegauge::Experiment{.name = "count",
                                           .configuration = [document] { return document; },
                                           .input_paths = {dataset.root},
                                           .run = run};
           }});
}

nlohmann::json experiment() {
  return {{"name", "own"},
          {"dataset", {{"generate", {{"classes", 2}, {"models_per_class", 3}, {"faces", 1000}}}}},
          {"perturbations", {{{"type", "stretch"}, {"by", 3}}}},
          {"signatures",
           {{{"name", "heights"},
             {"field", {{"type", "height"}, {"factor", 2}}},
             {"histogram", {{"bins", 8}, {"range", {{"fixed", {0, 4}}}}}}},
            {{"name", "extents"}, {"descriptor", {{"type", "extent"}}}},
            {{"name", "squares"}, {"rerank", {{"of", "heights"}, {"method", "squares"}}}}}},
          {"evaluation", {{"measures", {"NN", "hit@1"}}}},
          {"distance", "largest"},
          {"report", false}};
}

}  // namespace

int main(int /*count*/, char** arguments) {
  add_field();
  add_descriptor();
  add_perturbation();
  add_distance();
  add_measure();
  add_file_format();
  add_layout();
  add_rerank_method();
  add_experiment_kind();

  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "two.points") << "0 0 0\n1 2 3\n";
  const shapegauge::Shape two = shapegauge::read_shape(folder / "two.points");
  std::cout << "points " << two.vertices.rows() << ", the last at " << two.vertices.row(1) << '\n';

  const auto configuration = shapegauge::configuration_from_json(experiment(), "own", folder);
  const auto results = shapegauge::run_experiment(configuration, folder / "dataset", {});
  const shapegauge::MethodResults& method = results.methods[0];
  const auto& histograms = method.signatures;
  const double largest = (histograms.row(0) - histograms.row(1)).cast<double>().cwiseAbs().maxCoeff();
  const auto& scores = method.evaluations[0].micro;
  std::cout << "models " << results.models.size() << ", distance " << std::boolalpha
            << (method.distances(0, 1) == largest && largest > 0) << ", measure " << (scores[0] == scores[1])
            << ", features " << results.methods[1].signatures.cols() << ", square "
            << (results.methods[2].distances(0, 1) == largest * largest) << '\n';

  shapegauge::Cache none;
  const auto count = shapegauge::read_experiment({{"count", "."}}, "own", folder);
  const auto outcome = shapegauge::run_into_folder(count, folder / "counted", false, {}, none);
  std::cout << outcome.summary << '\n';
}
