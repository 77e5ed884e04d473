// SPDX-License-Identifier: GPL-3.0-or-later
// Iterations in the lanes of vectors, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/nearest_offset_point.cpp"
#include "shapegauge/core/offset/nearest_offset_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <span>

#include "shapegauge/core/offset/offset_step-inl.h"
#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/offset/search_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

/// Triangle, -1 if there is none, with the half-space that its ball of radius r leaves free: normal . x >= height.
struct Contact {
  IntegerLanes triangle;
  VectorLanes normal;
  RealLanes height;
  VectorLanes point;      ///< centre of the ball, on the triangle
  LaneBits retained = 0;  ///< lanes that keep the contact after the last step
};

/// Searches in the lanes of vectors.
class OffsetPointLanes {
 public:
  OffsetPointLanes(const ExteriorGrid& exterior, ClosestTriangles& closest)
      : exterior_(exterior),
        closest_(closest),
        records_(exterior.surface().triangles.records()),
        r_(static_cast<float>(exterior.grid().r)) {
    for (Contact& contact : contacts_) remove(contact, mask_of(all_lanes()));
    for (VectorLanes* vectors : {&origin_, &x_, &last_step_, &known_}) store(zero_vectors(), *vectors);
    store(real(infinity), step_length_);
    store(real(0), trust_radius_);
  }

  /// Prepares a lane for a task.
  void begin(std::size_t lane, OffsetPointTask& task) {
    const Eigen::Vector3f origin = task.p.cast<float>();
    origin_.set(lane, origin);
    x_.set(lane, (task.start - origin.cast<double>()).cast<float>());
    known_.set(lane, (task.known - origin.cast<double>()).cast<float>());
    last_step_.set(lane, Eigen::Vector3f::Zero());
    step_length_[lane] = infinity;
    trust_radius_[lane] = 0.1F;
    steps_[lane] = 0;
    task_[lane] = &task;
    is_found_ &= ~(LaneBits{1} << lane);
    at_contacts_[0].triangle[lane] = task.triangle;
  }

  /// Makes one step of each running search. Returns those that have ended.
  LaneBits step(LaneBits running, LaneBits started) {
    if (started != 0) {
      measure(records_, sum(load(origin_), load(x_)), at_contacts_[0]);
      set(contacts_[0], mask_of(started), at_contacts_[0]);
    }
    const LaneBits moving = running & advance();
    collect_triangles(moving);
    const LaneBits ended = running & ~(moving & evaluate(moving));
    if (ended != 0) finish(ended);
    return ended;
  }

 private:
  void finish(LaneBits lanes) {
    for_each_lane(lanes, [&](std::size_t lane) {
      OffsetPointTask& task = *task_[lane];
      task.found.reset();
      if ((is_found_ >> lane & 1U) != 0) task.found = origin_.at(lane) + found_.at(lane);
    });
    for (Contact& contact : contacts_) remove(contact, mask_of(lanes));
  }

  /// Moves x towards the projection of p onto the contacts' half-spaces. Returns the lanes in which there is one.
  LaneBits advance() {
    const Reals max_step = real(0.4F * r_);  // walls are thicker
    const Projection<Reals> to = Projector<Reals>(half_spaces()).find();
    const Vectors x = load(x_);
    const Vectors step = corrected(to, difference(to.x, x));
    const Reals length = length_of(step);
    const Mask is_long = hn::Gt(length, max_step);
    const Vectors moved = plus_product(x, hn::IfThenElse(is_long, hn::Div(max_step, length), real(1)), step);
    is_truncated_ = bits_of(is_long);
    for (Contact& contact : contacts_) {
      const Reals excess = hn::Sub(dot(load(contact.normal), moved), load(contact.height));
      const Mask is_touched = hn::Or(is_long, hn::Le(excess, real(tolerance)));
      contact.retained = bits_of(hn::And(is_touched, is_triangle(load(contact.triangle))));
    }
    const Mask oscillates =
        hn::And(hn::Lt(dot(step, load(last_step_)), real(0)), hn::Gt(length, hn::Mul(real(0.5F), load(step_length_))));
    const Reals trust_radius = load(trust_radius_);
    store(hn::IfThenElse(oscillates, hn::Mul(real(0.5F), trust_radius), trust_radius), trust_radius_);
    store(moved, x_);
    store(step, last_step_);
    store(length, step_length_);
    return bits_of(to.is_found);
  }

  /// Returns the step with its curvature correction, shortened if the whole exceeds the trust radius.
  HWY_INLINE Vectors corrected(const Projection<Reals>& to, const Vectors& step) const {
    const Reals available = hn::Sub(hn::Mul(load(trust_radius_), real(r_)), length_of(step));
    const Mask may_grow = hn::Gt(available, real(0));
    if (hn::AllFalse(D(), may_grow)) return step;
    const Vectors more = curvature_correction<Reals>(to, {active_contact(to, 0), active_contact(to, 1)}, step, r_);
    const Reals length = length_of(more);
    const Reals part = hn::IfThenElse(hn::Gt(length, available), hn::Div(available, length), real(1));
    return select(may_grow, plus_product(step, part, more), step);
  }

  HWY_INLINE std::array<HalfSpace<Reals>, max_contacts> half_spaces() const {
    std::array<HalfSpace<Reals>, max_contacts> all;
    for (std::size_t i = 0; i < max_contacts; ++i) all[i] = {load(contacts_[i].normal), load(contacts_[i].height)};
    return all;
  }

  /// Returns the k-th active contact of a projection.
  HWY_INLINE ActiveContact<Reals> active_contact(const Projection<Reals>& to, std::size_t k) const {
    Integers triangle = integer(-1);
    Vectors normal = zero_vectors();
    Vectors point = zero_vectors();
    for (std::size_t i = 0; i < max_contacts; ++i) {
      const hn::Mask<DI> is_active = hn::Eq(to.contacts[k], integer(static_cast<std::int32_t>(i)));
      triangle = hn::IfThenElse(is_active, load(contacts_[i].triangle), triangle);
      normal = select(real_mask(is_active), load(contacts_[i].normal), normal);
      point = select(real_mask(is_active), load(contacts_[i].point), point);
    }
    IntegerLanes numbers;
    store(hn::Max(triangle, integer(0)), numbers);
    Reals record[16];
    load_transposed(D(), records_, numbers.data(), record);
    return {normal, feature_at(record, sum(load(origin_), point))};
  }

  /// Collects the triangles around x and, close to convergence, those nearest to the contacts.
  void collect_triangles(LaneBits moving) {
    constexpr float nearly_settled = 0.05F;  // of a step's length, in units of r
    const Vectors x = sum(load(origin_), load(x_));
    touches_exterior_ = bits_of(find_cell_triangles(exterior_, lowest_cells_around(exterior_, x), others_.data()));
    others_count_ = cells_around_point;
    // On fine meshes the closest triangle is seldom one of the cells' but close to a contact.
    const LaneBits close = moving & bits_of(hn::Lt(load(step_length_), real(nearly_settled * r_)));
    std::array<VectorLanes, max_contacts> positions;
    for (std::size_t i = 0; i < max_contacts; ++i) {
      if ((close & contacts_[i].retained) != 0)
        store(minus_product(x, real(r_), load(contacts_[i].normal)), positions[i]);
    }
    for_each_lane(close, [&](std::size_t lane) { collect_near_contacts(lane, positions); });
  }

  /// Collects the triangles nearest to the retained contacts of a lane, given positions on them, unless they are
  /// contacts.
  void collect_near_contacts(std::size_t lane, const std::array<VectorLanes, max_contacts>& positions) {
    const Eigen::Vector3d x = origin_.at(lane) + x_.at(lane);
    std::size_t next = cells_around_point;
    for (std::size_t i = 0; i < max_contacts; ++i) {
      if ((contacts_[i].retained >> lane & 1U) == 0) continue;
      const std::int32_t triangle = closest_.closest_near(positions[i].at(lane), x);
      const bool is_contact = std::any_of(contacts_.begin(), contacts_.end(),
                                          [&](const Contact& contact) { return contact.triangle[lane] == triangle; });
      if (triangle < 0 || is_contact) continue;
      if (next == others_count_) others_[others_count_++].triangle.fill(-1);
      others_[next++].triangle[lane] = triangle;
    }
  }

  /// Computes the vectors from triangles to x, and decides which lanes are free and settled. Returns those that go on.
  LaneBits evaluate(LaneBits moving) {
    constexpr float settled = 0.01F;  // of a step's length, in units of r
    constexpr float near_known = 0.3F;
    constexpr int max_steps = 12;
    const Reals least = measure_all();
    const Reals covering2 = real(covering() * covering());
    LaneBits going = moving & bits_of(hn::Gt(least, real(0)));
    const LaneBits free = going & ~is_truncated_ & ~bits_of(hn::Lt(least, covering2));
    for_each_lane(free & ~touches_exterior_, [&](std::size_t lane) {
      // x is free but enclosed, and no further step can leave the enclosure.
      const Eigen::Vector3d x = origin_.at(lane) + x_.at(lane);
      if (!is_connected_to(exterior_, x, task_[lane]->start)) going &= ~(LaneBits{1} << lane);
    });
    const LaneBits found = free & going;
    store(select(mask_of(found), load(x_), load(found_)), found_);
    is_found_ |= found;
    const LaneBits is_settled = found & bits_of(hn::Lt(load(step_length_), real(settled * r_)));
    const Vectors to_known = difference(load(known_), load(x_));
    const LaneBits is_known = found & ~is_settled & bits_of(hn::Lt(length_of(to_known), real(near_known * r_)));
    is_found_ &= ~is_known;
    going &= ~is_settled & ~is_known;
    for_each_lane(going, [&](std::size_t lane) {
      if (++steps_[lane] == max_steps) going &= ~(LaneBits{1} << lane);
    });
    return going & renew_contacts();
  }

  /// Computes the vectors from all surrounding triangles to x. Returns the smallest squared length.
  HWY_INLINE Reals measure_all() {
    const Vectors x = sum(load(origin_), load(x_));
    Reals least = real(infinity);
    for (std::size_t i = 0; i < max_contacts; ++i) {
      at_contacts_[i].triangle = contacts_[i].triangle;
      measure(records_, x, at_contacts_[i]);
      least = hn::Min(least, load(at_contacts_[i].squared));
    }
    for (std::size_t i = 0; i < others_count_; ++i) {
      measure(records_, x, others_[i]);
      least = hn::Min(least, load(others_[i].squared));
    }
    return least;
  }

  /// Updates the retained contacts at x, and adds up to two new ones that cover x: the closest, and the closest in
  /// another direction. Returns the lanes with contacts.
  LaneBits renew_contacts() {
    hide_known();
    for (std::size_t i = 0; i < max_contacts; ++i) {
      const Mask is_retained = mask_of(contacts_[i].retained);
      set(contacts_[i], is_retained, at_contacts_[i]);
      remove(contacts_[i], hn::Not(is_retained));
    }
    const TriangleLanes first = closest_covering(zero_vectors(), infinity);
    add(first);
    constexpr float same_direction = 0.985F;
    const Mask has_first = is_triangle(load(first.triangle));
    const Reals inverse = hn::IfThenElse(has_first, hn::Div(real(1), hn::Sqrt(load(first.squared))), real(0));
    add(closest_covering(product(inverse, load(first.vector)), same_direction));
    Mask any = empty_mask();
    for (const Contact& contact : contacts_) any = hn::Or(any, is_triangle(load(contact.triangle)));
    return bits_of(any);
  }

  /// Removes the triangles that have been contacts from the others.
  HWY_INLINE void hide_known() {
    for (std::size_t s = 0; s < others_count_; ++s) {
      const Integers triangle = load(others_[s].triangle);
      hn::Mask<DI> is_known = hn::Eq(triangle, load(contacts_[0].triangle));
      for (std::size_t i = 1; i < max_contacts; ++i) {
        is_known = hn::Or(is_known, hn::Eq(triangle, load(contacts_[i].triangle)));
      }
      store(hn::IfThenElse(real_mask(is_known), real(infinity), load(others_[s].squared)), others_[s].squared);
    }
  }

  /// Returns the closest of the other triangles that cover x and whose direction has a cosine of at most `max_cosine`
  /// with `direction`.
  HWY_INLINE TriangleLanes closest_covering(const Vectors& direction, float max_cosine) const {
    Reals least = real(covering() * covering());
    Vectors closest = zero_vectors();
    Integers number = integer(-1);
    for (std::size_t s = 0; s < others_count_; ++s) {
      const Reals squared = load(others_[s].squared);
      const Vectors vector = load(others_[s].vector);
      const Mask is_other_direction = hn::Le(dot(vector, direction), hn::Mul(real(max_cosine), hn::Sqrt(squared)));
      const Mask is_closer = hn::And(hn::Lt(squared, least), is_other_direction);
      least = hn::IfThenElse(is_closer, squared, least);
      closest = select(is_closer, vector, closest);
      number = hn::IfThenElse(integer_mask(is_closer), load(others_[s].triangle), number);
    }
    TriangleLanes result;
    store(number, result.triangle);
    store(closest, result.vector);
    store(least, result.squared);
    return result;
  }

  /// Adds a contact where there is room.
  HWY_INLINE void add(const TriangleLanes& surrounding) {
    Mask waiting = is_triangle(load(surrounding.triangle));
    for (Contact& contact : contacts_) {
      const Mask is_free = hn::AndNot(is_triangle(load(contact.triangle)), waiting);
      if (!hn::AllFalse(D(), is_free)) set(contact, is_free, surrounding);
      waiting = hn::AndNot(is_free, waiting);
    }
  }

  HWY_INLINE void set(Contact& contact, Mask where, const TriangleLanes& surrounding) const {
    const Vectors x = load(x_);
    const Vectors vector = load(surrounding.vector);
    const HalfSpace<Reals> free = tangent_half_space(x, vector, hn::Sqrt(load(surrounding.squared)), r_);
    store(select(where, free.normal, load(contact.normal)), contact.normal);
    store(select(where, difference(x, vector), load(contact.point)), contact.point);
    store(hn::IfThenElse(where, free.height, load(contact.height)), contact.height);
    store(hn::IfThenElse(integer_mask(where), load(surrounding.triangle), load(contact.triangle)), contact.triangle);
  }

  HWY_INLINE static void remove(Contact& contact, Mask where) {
    store(select(where, zero_vectors(), load(contact.normal)), contact.normal);
    store(select(where, zero_vectors(), load(contact.point)), contact.point);
    store(hn::IfThenElse(where, real(unbounded_height), load(contact.height)), contact.height);
    store(hn::IfThenElse(integer_mask(where), integer(-1), load(contact.triangle)), contact.triangle);
  }

  /// Triangles closer than this cover x.
  [[nodiscard]] float covering() const {
    constexpr float relative = 2e-4F;
    return r_ * (1 - relative);
  }

  const ExteriorGrid& exterior_;
  ClosestTriangles& closest_;
  const float* records_;
  float r_;
  std::array<OffsetPointTask*, max_lanes> task_{};
  std::array<int, max_lanes> steps_{};
  LaneBits is_found_ = 0;
  LaneBits is_truncated_ = 0;  ///< the last step was shortened
  LaneBits touches_exterior_ = 0;
  VectorLanes origin_;  ///< p; all other positions are relative to it
  VectorLanes x_, found_{}, known_, last_step_;
  RealLanes step_length_;   ///< length of the last step, before it was shortened
  RealLanes trust_radius_;  ///< maximum correction of a step, in units of r
  std::array<Contact, max_contacts> contacts_{};
  std::array<TriangleLanes, max_contacts> at_contacts_{};
  std::array<TriangleLanes, cells_around_point + max_contacts> others_{};  ///< around x
  std::size_t others_count_ = 0;
};

void find_points(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetPointTask> tasks) {
  OffsetPointLanes lanes(exterior, closest);
  run_in_lanes(
      tasks, [&](std::size_t lane, OffsetPointTask& task) { lanes.begin(lane, task); },
      [&](LaneBits running, LaneBits started) { return lanes.step(running, started); });
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(find_points);

void find_nearest_offset_points(const ExteriorGrid& exterior, ClosestTriangles& closest,
                                std::span<OffsetPointTask> tasks) {
  if (!tasks.empty()) HWY_DYNAMIC_DISPATCH(find_points)(exterior, closest, tasks);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
