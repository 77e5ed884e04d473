// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/proxy_geodesics.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/spatial/morton_order.h"

namespace shapegauge {

namespace {

constexpr float unreached = std::numeric_limits<float>::infinity();

/// Number of landmarks processed in parallel, one in each lane of vector registers.
constexpr int lanes = 16;
using Lanes = Eigen::Array<float, lanes, 1>;

/// Returns the points in order of distance from one of them (Dijkstra's algorithm).
std::vector<std::int32_t> outward_order(const SurfaceProxy& proxy, std::int32_t source) {
  using Entry = std::pair<float, std::int32_t>;
  const auto count = static_cast<std::size_t>(proxy.points.rows());
  std::vector<float> distance(count, unreached);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<std::int32_t> order;
  distance[static_cast<std::size_t>(source)] = 0;
  open.emplace(0.0F, source);
  while (!open.empty()) {
    const auto [reached, from] = open.top();
    open.pop();
    if (reached > distance[static_cast<std::size_t>(from)]) continue;
    order.push_back(from);
    for (const ProxyArc& arc : proxy.arcs_of(static_cast<std::size_t>(from))) {
      float& known = distance[static_cast<std::size_t>(arc.to)];
      if (!(reached + arc.length < known)) continue;
      known = reached + arc.length;
      open.emplace(known, arc.to);
    }
  }
  return order;
}

/// Computes shortest paths from several nearby landmarks at once: sweeps over the points, outwards from the landmarks
/// and back, until no distance changes. The result equals that of Dijkstra's algorithm, whatever the order.
class LandmarkBatch {
 public:
  explicit LandmarkBatch(const SurfaceProxy& proxy)
      : proxy_(&proxy), distances_(static_cast<std::size_t>(proxy.points.rows())), pending_(distances_.size()) {}

  const std::vector<Lanes>& solve(std::span<const std::int32_t> sources) {
    std::ranges::fill(distances_, Lanes::Constant(unreached));
    std::ranges::fill(pending_, 0);
    for (std::size_t lane = 0; lane < sources.size(); ++lane) {
      const auto source = static_cast<std::size_t>(sources[lane]);
      distances_[source][static_cast<Eigen::Index>(lane)] = 0;
      mark_neighbours(source);
    }
    const std::vector<std::int32_t> order = outward_order(*proxy_, sources[sources.size() / 2]);
    for (bool outwards = true; pending_count_ > 0; outwards = !outwards) {
      check_interruption();
      for (std::size_t k = 0; k < order.size(); ++k) {
        update(static_cast<std::size_t>(outwards ? order[k] : order[order.size() - 1 - k]));
      }
    }
    return distances_;
  }

 private:
  void mark_neighbours(std::size_t point) {
    for (const ProxyArc& arc : proxy_->arcs_of(point)) {
      char& mark = pending_[static_cast<std::size_t>(arc.to)];
      pending_count_ += mark == 0 ? 1 : 0;
      mark = 1;
    }
  }

  void update(std::size_t point) {
    if (pending_[point] == 0) return;
    pending_[point] = 0;
    --pending_count_;
    Lanes best = distances_[point];
    for (const ProxyArc& arc : proxy_->arcs_of(point)) {
      best = best.min(distances_[static_cast<std::size_t>(arc.to)] + arc.length);
    }
    if ((best == distances_[point]).all()) return;
    distances_[point] = best;
    mark_neighbours(point);
  }

  const SurfaceProxy* proxy_;
  std::vector<Lanes> distances_;
  std::vector<char> pending_;
  std::size_t pending_count_ = 0;
};

}  // namespace

ProxyGeodesics proxy_geodesics(const SurfaceProxy& proxy, Eigen::Index landmarks) {
  landmarks = std::min(landmarks, proxy.points.rows());
  ProxyGeodesics result{Eigen::MatrixXf(proxy.points.rows(), landmarks), Eigen::VectorXd::Zero(landmarks)};
  const std::vector<std::int32_t> order = morton_order(proxy.points.topRows(landmarks));
  LandmarkBatch batch(proxy);
  for (std::size_t first = 0; first < order.size(); first += lanes) {
    const auto sources = std::span(order).subspan(first, std::min<std::size_t>(lanes, order.size() - first));
    const std::vector<Lanes>& distances = batch.solve(sources);
    for (std::size_t lane = 0; lane < sources.size(); ++lane) {
      auto column = result.distances.col(sources[lane]);
      for (Eigen::Index i = 0; i < column.size(); ++i) {
        column[i] = distances[static_cast<std::size_t>(i)][static_cast<Eigen::Index>(lane)];
      }
    }
  }
  for (Eigen::Index i = 0; i < proxy.points.rows(); ++i) {
    Eigen::Index nearest = 0;
    result.distances.row(i).minCoeff(&nearest);
    result.areas[nearest] += proxy.areas[i];
  }
  return result;
}

}  // namespace shapegauge
