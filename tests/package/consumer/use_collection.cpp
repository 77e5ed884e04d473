#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/search/search.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/seg_file.h"

namespace sg = shapegauge;

// Prints the first tier of the descriptor D2 on a data set.
void evaluate_descriptor(const std::filesystem::path& folder) {
  const sg::Dataset dataset = sg::find_dataset(sg::recognise_dataset(folder));
  sg::Signatures features(dataset.models.size(), 64);
  std::vector<int> labels;
  for (const sg::Model& model : dataset.models) {
    features.row(labels.size()) = sg::d2(sg::read_shape(model.file)).transpose();
    labels.push_back(model.label);
  }
  const sg::EvaluationOptions options{.measures = {sg::measure_of("FT")}};
  const sg::Evaluation evaluation = sg::evaluate(sg::distance_matrix(features, "l1"), labels, options);
  std::cout << "FT " << evaluation.micro[0] << '\n';
}

// Prints the two shapes of a folder that are most similar to a shape. The index is written next to the folder.
void print_nearest(const std::filesystem::path& folder, const std::string& shape) {
  sg::Cache no_cache;
  sg::IndexUpdate update;
  sg::OpenIndex index =
      sg::open_index(sg::recommended_search_method(), folder, sg::default_index_path(folder), {}, no_cache, update);
  const std::vector<sg::SearchQuery> queries{{.name = shape, .file = shape}};
  std::vector<std::string> notes;
  for (const sg::SearchAnswer& answer : sg::search(index, queries, {.count = 2}, {}, no_cache, notes)) {
    for (const sg::RankedModel& one : answer.nearest) std::cout << index.contents.models[one.model].id << '\n';
  }
}

// Writes the part of each face of a shape.
void segment(const std::filesystem::path& file) {
  const sg::Shape shape = sg::read_shape(file);
  const std::vector<std::int32_t> parts = sg::part_segmentation(shape, {});
  sg::write_seg("parts.seg", shape, parts);
}

int main(int /*count*/, char** arguments) {
  try {
    evaluate_descriptor(arguments[1]);
    print_nearest(arguments[1], arguments[2]);
    segment(arguments[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
