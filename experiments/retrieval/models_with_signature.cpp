#include "shapegauge/experiments/retrieval/models_with_signature.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "shapegauge/experiments/distributed/packing.h"

namespace shapegauge {

ModelsWithSignature::ModelsWithSignature(const std::vector<ModelFailure>& without, std::size_t all)
    : is_in_(all, true) {
  for (const ModelFailure& failure : without) is_in_[failure.model] = false;
  for (std::size_t i = 0; i < all; ++i) {
    if (is_in_[i]) places_.push_back(static_cast<Eigen::Index>(i));
  }
}

DistanceMatrix ModelsWithSignature::spread(DistanceMatrix between) const {
  if (are_all()) return between;
  const auto all = std::ssize(is_in_);
  DistanceMatrix distances = DistanceMatrix::Constant(all, all, std::numeric_limits<double>::infinity());
  distances(places_, places_) = between;
  distances.diagonal().setZero();
  return distances;
}

void ModelsWithSignature::set_infinite(DistanceMatrix& rows, Eigen::Index first) const {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      if (is_in_[static_cast<std::size_t>(first + i)] && is_in_[static_cast<std::size_t>(j)]) continue;
      rows(i, j) = first + i == j ? 0 : std::numeric_limits<double>::infinity();
    }
  }
}

Signatures ModelsWithSignature::with_stand_ins(const Signatures& rows, const RankRange& own,
                                               Communicator& ranks) const {
  const auto first = static_cast<std::size_t>(places_.front());
  const bool is_here = first >= own.first && first < own.last;
  const auto local = static_cast<Eigen::Index>(first - own.first);
  std::string told;
  for (const std::string& part :
       ranks.gather(is_here ? std::move(Packer().add(Signatures(rows.row(local)))).bytes() : std::string())) {
    if (!part.empty()) told = part;
  }
  const auto stand_in = Unpacker(ranks.broadcast(std::move(told))).take_value<Signatures>();
  Signatures filled = rows;
  for (Eigen::Index i = 0; i < filled.rows(); ++i) {
    const auto model = static_cast<Eigen::Index>(own.first) + i;
    if (!std::ranges::binary_search(places_, model)) filled.row(i) = stand_in.row(0);
  }
  return filled;
}

}  // namespace shapegauge
