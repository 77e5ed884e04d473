#include "shapegauge/retrieval/signature.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace shapegauge {
namespace {

// Brings a row of parts that lie side by side to sum 1.
void normalise(Eigen::Ref<Eigen::RowVectorXf> signature) {
  double total = 0;
  for (Eigen::Index i = 0; i < signature.size(); ++i) {
    const float entry = signature[i];
    if (!(entry >= 0) || !std::isfinite(entry)) {
      throw std::invalid_argument("entry " + std::to_string(i) + " of a signature is " + std::to_string(entry) +
                                  "; only finite entries that are not negative can be concatenated");
    }
    total += entry;
  }
  if (!(total > 0)) throw std::invalid_argument("a signature of zeros only cannot be normalised");
  signature = (signature.cast<double>() / total).cast<float>();
}

}  // namespace

Signatures concatenate(std::span<const Signatures> parts) {
  if (parts.empty()) throw std::invalid_argument("no signatures to concatenate");
  Eigen::Index length = 0;
  for (const Signatures& part : parts) {
    if (part.rows() != parts.front().rows()) {
      throw std::invalid_argument("signatures of " + std::to_string(parts.front().rows()) + " and of " +
                                  std::to_string(part.rows()) + " shapes cannot be concatenated");
    }
    length += part.cols();
  }
  Signatures whole(parts.front().rows(), length);
  Eigen::Index column = 0;
  for (const Signatures& part : parts) {
    whole.middleCols(column, part.cols()) = part;
    column += part.cols();
  }
  for (Eigen::Index row = 0; row < whole.rows(); ++row) normalise(whole.row(row));
  return whole;
}

Eigen::VectorXf concatenate(std::span<const Eigen::VectorXf> parts) {
  std::vector<Signatures> rows;
  rows.reserve(parts.size());
  for (const Eigen::VectorXf& part : parts) rows.emplace_back(part.transpose());
  return concatenate(rows).row(0).transpose();
}

}  // namespace shapegauge
