// The toy of seven numbers in two classes whose nearest-neighbour score is known, through every module.
#include <algorithm>
#include <iostream>
#include <vector>

#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distance_matrix.h"

int main() {
  if (!shapegauge::natural_less("T2", "T10")) return 1;
  const shapegauge::Signatures values{{0.0F}, {1.0F}, {4.0F}, {2.0F}, {3.5F}, {7.0F}, {9.0F}};
  const std::vector<int> labels{0, 0, 0, 1, 1, 1, 1};
  const shapegauge::DistanceMatrix distances = shapegauge::distance_matrix(values, "l1");
  const shapegauge::Evaluation evaluation = shapegauge::evaluate(distances, labels, {});
  const auto column = std::ranges::find(evaluation.measures, "NN") - evaluation.measures.begin();
  std::cout << "shapegauge " << shapegauge::version() << ": NN " << evaluation.micro[column] << '\n';
}
