#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "shapegauge/metrics/evaluation.h"

int main() {
  const Eigen::VectorXd values{{0, 1, 4, 2, 3.5, 7, 9}};
  const std::vector<int> labels{0, 0, 0, 1, 1, 1, 1};
  Eigen::Matrix<double, 7, 7, Eigen::RowMajor> distances;
  for (Eigen::Index i = 0; i < 7; ++i) {
    for (Eigen::Index j = 0; j < 7; ++j) distances(i, j) = std::abs(values[i] - values[j]);
  }
  const shapegauge::Evaluation evaluation = shapegauge::evaluate(distances, labels, {});
  const auto column = std::ranges::find(evaluation.measures, "FT") - evaluation.measures.begin();
  std::cout << "FT " << evaluation.micro[column] << '\n';
}
