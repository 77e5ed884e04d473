// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/offset_search.h"

#include "shapegauge/core/offset/offset_depth.h"

namespace shapegauge {

namespace {

/// Minimum distance, in cells, between sites from which iterations begin.
constexpr double start_spacing = 2;

}  // namespace

OffsetSearch::OffsetSearch(const ExteriorGrid& exterior, const OffsetSites& sites, ClosestTriangles& closest)
    : exterior_(exterior), sites_(sites), closest_(closest), r_(exterior.grid().r), nearby_(exterior, sites) {}

const std::vector<SearchedPoint>& OffsetSearch::find(std::span<const CoveredSample> samples) {
  begin(samples);
  while (collect_starts()) iterate();
  results_.clear();
  for (const Search& search : searches_) {
    results_.push_back({search.is_found() ? search.q : nearest_site(search), search.is_found()});
  }
  return results_;
}

void OffsetSearch::begin(std::span<const CoveredSample> samples) {
  searches_.clear();
  groups_.clear();
  for (const CoveredSample& sample : samples) {
    const std::size_t i = searches_.size();
    if (i == 0 || sample.group != searches_.back().sample.group) groups_.push_back({i, i, {}});
    searches_.push_back(
        {.sample = sample, .sides = {Side{.raised = sample.raised[0]}, Side{.raised = sample.raised[1]}}});
    for (const Eigen::Vector3d& raised : sample.raised) groups_.back().box.extend(raised);
    groups_.back().end = i + 1;
  }
}

/// Returns the next site from which the search begins on the current side; null if there is none.
const NearbySites::Site* OffsetSearch::next_start(Search& search) const {
  Side& side = search.side();
  while (side.next_start < side.start_count) {
    const NearbySites::Site& start = side.starts[side.next_start++];
    const bool is_known = search.is_found() && (sites_.position(start.site) - search.q).norm() < start_spacing;
    if (!is_known && static_cast<double>(start.distance) - gain() <= search.best) return &start;
  }
  return nullptr;
}

/// Turns to the other side. Returns false if it has had its turn, or is too far from the exterior.
bool OffsetSearch::turn_to_other_side(Search& search) const {
  if (search.is_last_side) return false;
  const double least = std::min(search.best, search.side().distance);
  search.is_last_side = true;
  search.current = 1 - search.current;
  return search.side().distance - gain() <= least;
}

/// Returns the next state of a search that is not iterating. Sets the task of an iteration.
OffsetSearch::State OffsetSearch::advance(Search& search, OffsetPointTask& task) const {
  Side& side = search.side();
  if (const NearbySites::Site* start = next_start(search)) {
    task = {.p = side.raised,
            .start = sites_.position(start->site),
            .triangle = sites_.triangle(start->site),
            .known = side.found,
            .found = {}};
    search.repeats = 0;
    return State::iteration;
  }
  if (!search.is_found() && !side.has_far_sites) return State::far_sites;
  return turn_to_other_side(search) ? advance(search, task) : State::end;
}

/// Returns the next state of a search whose iteration has ended: it is repeated if a triangle covers its result.
OffsetSearch::State OffsetSearch::advance_from_result(Search& search, OffsetPointTask& task) {
  constexpr int max_repeats = 3;
  if (!task.found) return advance(search, task);
  const Eigen::Vector3d x = *task.found;
  const std::int32_t triangle = search.repeats < max_repeats ? covering_triangle(search.sample, x) : -1;
  if (triangle >= 0) {
    ++search.repeats;
    task.start = x;
    task.triangle = triangle;
    return State::iteration;
  }
  keep_nearest(search, x);
  return advance(search, task);
}

/// Returns a triangle that covers the result x of an iteration: the sample's own or, if no surrounding cell is exterior
/// (at the end of a wedge), any. Returns -1 if there is none.
std::int32_t OffsetSearch::covering_triangle(const CoveredSample& sample, const Eigen::Vector3d& x) {
  const double least = (1 - surface_slack) * r_;
  if ((x - sample.p).norm() < least) return sample.triangle;
  if (cells_around(exterior_, x).touches_exterior) return -1;
  const std::int32_t closest = closest_.closest_within(r_, x);
  if (closest < 0) return -1;
  return exterior_.surface().triangles.squared_distance(x, closest) < least * least ? closest : -1;
}

/// Makes the result x of an iteration q if it is the nearest so far.
void OffsetSearch::keep_nearest(Search& search, const Eigen::Vector3d& x) const {
  constexpr double nearly_free = 0.8;  // of r
  const Eigen::Vector3d& p = search.sample.p;
  const double height = (x - p).norm();
  if (height < nearly_free * r_) return;
  const Eigen::Vector3d q = height < r_ ? Eigen::Vector3d(p + r_ / height * (x - p)) : x;
  const double distance = (q - search.side().raised).norm();
  if (!(distance < search.best)) return;
  search.best = distance;
  search.q = search.side().found = q;
}

/// Sets the distances from the raised samples to the nearest site, after collecting all sites that the search may use:
/// those up to far_margin() beyond a distance that exceeds the smaller one by at most gain(). If the larger exceeds the
/// smaller by more, it is a lower bound.
void OffsetSearch::measure(Search& search, const Eigen::AlignedBox3d& box) {
  constexpr double first_reach = 1.6;  // in units of r
  if (reach_ == 0) {
    reach_ = first_reach * r_;
    nearby_.collect(box, reach_);
  }
  std::array<double, 2> distances = nearby_.measure(search.sample.raised);
  const double beyond = 1.01 * (gain() + far_margin());
  if (std::min(distances[0], distances[1]) + beyond >= reach_) {
    // The nearest site of any position in the box is at most half of its diagonal farther than that of its centre.
    reach_ = nearby_.distance_to_nearest(box.center()) + box.diagonal().norm() / 2 + beyond;
    nearby_.collect(box, reach_);
    distances = nearby_.measure(search.sample.raised);
  }
  for (std::size_t side = 0; side < 2; ++side) search.sides[side].distance = distances[side];
}

/// Sets the starts of one side: sites whose distance exceeds the smallest by less than the margin.
void OffsetSearch::set_starts(Search& search, std::size_t side, double margin, double min_spacing,
                              std::size_t max_count) {
  Side& of = search.sides[side];
  nearby_.find_start_sites(side, margin, min_spacing, max_count, found_sites_);
  std::copy(found_sites_.begin(), found_sites_.end(), of.starts.begin());
  of.start_count = found_sites_.size();
  of.next_start = 0;
}

/// Collects the starts that a search waits for.
void OffsetSearch::collect_starts(Search& search, const Eigen::AlignedBox3d& box) {
  measure(search, box);
  if (search.state == State::far_sites) {
    search.side().has_far_sites = true;
    return set_starts(search, search.current, far_margin(), start_spacing / 2, max_starts);
  }
  const std::array<double, 2> distances{search.sides[0].distance, search.sides[1].distance};
  search.current = distances[0] <= distances[1] ? 0 : 1;
  search.is_last_side = search.sides[0].raised == search.sides[1].raised;
  for (const std::size_t side : {search.current, 1 - search.current}) {
    const bool is_used =
        side == search.current || (!search.is_last_side && distances[side] - gain() <= distances[1 - side]);
    if (is_used) set_starts(search, side, gain(), start_spacing, max_starts / 3);
  }
}

/// Collects the starts that searches wait for, group by group. Returns false if none waits.
bool OffsetSearch::collect_starts() {
  running_.clear();
  for (const Group& group : groups_) {
    reach_ = 0;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      Search& search = searches_[i];
      if (search.state != State::near_sites && search.state != State::far_sites) continue;
      collect_starts(search, group.box);
      running_.push_back(i);
    }
  }
  return !running_.empty();
}

/// Makes the transition of all running searches; those that iterate keep running.
template <typename Transition>
void OffsetSearch::advance_all(const Transition& transition) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < running_.size(); ++i) {
    Search& search = searches_[running_[i]];
    search.state = transition(search, tasks_[i]);
    if (search.state != State::iteration) continue;
    tasks_[count] = tasks_[i];
    running_[count++] = running_[i];
  }
  tasks_.resize(count);
  running_.resize(count);
}

/// Iterates from the starts of the running searches until each ends or needs more sites.
void OffsetSearch::iterate() {
  tasks_.resize(running_.size());
  advance_all([this](Search& search, OffsetPointTask& task) { return advance(search, task); });
  while (!tasks_.empty()) {
    find_nearest_offset_points(exterior_, closest_, tasks_);
    advance_all([this](Search& search, OffsetPointTask& task) { return advance_from_result(search, task); });
  }
}

/// Returns the site nearest to the sample raised on the nearer side.
Eigen::Vector3d OffsetSearch::nearest_site(const Search& search) const {
  const Side& side = search.sides[search.sides[0].distance <= search.sides[1].distance ? 0 : 1];
  if (side.start_count == 0) return search.sample.p + r_ * Eigen::Vector3d::UnitZ();
  return sites_.position(side.starts.front().site);
}

}  // namespace shapegauge
