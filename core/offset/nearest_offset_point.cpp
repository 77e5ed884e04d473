// Iterations in the lanes of vectors, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/nearest_offset_point.cpp"
#include "shapegauge/core/offset/nearest_offset_point.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>
#include <span>

#include "shapegauge/core/offset/half_space_projection-inl.h"
#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/offset/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

/// Features of triangles.
struct Features {
  Mask is_face;
  Vectors edge;  ///< unit direction of the edge; zero at corners
};

/// Returns the features that contain points of triangles.
HWY_INLINE Features features_at(const float* records, Integers triangle, const Vectors& point) {
  IntegerLanes numbers;
  store(hn::Max(triangle, integer(0)), numbers);
  Reals field[16];
  load_transposed(D(), records, numbers.data(), field);
  const Reals inside = real(1e-3F);
  const Vectors from_a = difference(point, {field[0], field[1], field[2]});
  const Vectors ab{field[3], field[4], field[5]};
  const Vectors ac{field[6], field[7], field[8]};
  const Reals v = dot<D>(from_a, {field[9], field[10], field[11]});
  const Reals w = dot<D>(from_a, {field[12], field[13], field[14]});
  // NaN, for a degenerate triangle, counts as on all three edges.
  const Mask off_ab = hn::Gt(w, inside);
  const Mask off_ac = hn::Gt(v, inside);
  const Mask off_bc = hn::Gt(hn::Sub(real(1), hn::Add(v, w)), inside);
  const Mask is_on_edge = hn::Or(hn::And(off_ab, hn::Or(off_ac, off_bc)), hn::And(off_ac, off_bc));
  const Vectors edge = select<D>(off_ab, select<D>(off_ac, difference(ac, ab), ac), ab);
  const Vectors direction = product(hn::Div(real(1), length_of(edge)), edge);
  return {hn::And(off_ab, hn::And(off_ac, off_bc)), select<D>(is_on_edge, direction, no_vector())};
}

/// Searches in the lanes of vectors. A lane whose search ends takes the next one.
class OffsetPointLanes {
 public:
  OffsetPointLanes(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetPointTask> tasks)
      : exterior_(exterior),
        closest_(closest),
        records_(exterior.surface().triangles.records()),
        r_(static_cast<float>(exterior.grid().r)),
        tasks_(tasks) {
    for (Contact& contact : contacts_) remove(contact, mask_of(all_lanes()));
    for (VectorLanes* vectors : {&origin_, &x_, &last_step_, &known_}) store(no_vector(), *vectors);
    store(real(infinity), step_length_);
    store(real(0), trust_radius_);
  }

  void run() {
    while (start() || active_ != 0) {
      const LaneBits moving = active_ & advance();
      collect_triangles(moving);
      finish(active_ & ~(moving & evaluate(moving)));
    }
  }

 private:
  /// Starts waiting tasks in idle lanes. Returns false if there is none.
  bool start() {
    LaneBits started = 0;
    for (std::size_t lane = 0; lane < hn::Lanes(D()) && next_task_ < tasks_.size(); ++lane) {
      const LaneBits bit = LaneBits{1} << lane;
      if ((active_ & bit) != 0) continue;
      start(lane, next_task_++);
      started |= bit;
    }
    if (started == 0) return false;
    active_ |= started;
    measure(records_, sum(load(origin_), load(x_)), at_contacts_[0]);
    set(contacts_[0], mask_of(started), at_contacts_[0]);
    return true;
  }

  void start(std::size_t lane, std::size_t number) {
    const OffsetPointTask& task = tasks_[number];
    const Eigen::Vector3f origin = task.p.cast<float>();
    origin_.set(lane, origin);
    x_.set(lane, (task.start - origin.cast<double>()).cast<float>());
    known_.set(lane, (task.known - origin.cast<double>()).cast<float>());
    last_step_.set(lane, Eigen::Vector3f::Zero());
    step_length_[lane] = infinity;
    trust_radius_[lane] = 0.1F;
    steps_[lane] = 0;
    task_[lane] = number;
    is_found_ &= ~(LaneBits{1} << lane);
    at_contacts_[0].triangle[lane] = task.triangle;
  }

  /// Ends searches.
  void finish(LaneBits lanes) {
    for_each_lane(lanes, [&](std::size_t lane) {
      OffsetPointTask& task = tasks_[task_[lane]];
      task.found.reset();
      if ((is_found_ >> lane & 1U) != 0) task.found = origin_.at(lane) + found_.at(lane);
    });
    if (lanes == 0) return;
    for (Contact& contact : contacts_) remove(contact, mask_of(lanes));
    active_ &= ~lanes;
  }

  /// Moves x towards the projection of p onto the contacts' half-spaces. Returns the lanes in which there is one.
  LaneBits advance() {
    const Reals max_step = real(0.4F * r_);  // walls are thicker
    const Projections to = Projector(contacts_).find();
    const Vectors x = load(x_);
    const Vectors step = corrected(to, difference(to.x, x));
    const Reals length = length_of(step);
    const Mask is_long = hn::Gt(length, max_step);
    const Vectors moved = plus_product(x, hn::IfThenElse(is_long, hn::Div(max_step, length), real(1)), step);
    is_truncated_ = bits_of(is_long);
    for (Contact& contact : contacts_) {
      const Reals excess = hn::Sub(dot<D>(load(contact.normal), moved), load(contact.height));
      const Mask is_touched = hn::Or(is_long, hn::Le(excess, real(tolerance)));
      contact.kept = bits_of(hn::And(is_touched, is_triangle(load(contact.triangle))));
    }
    const Mask oscillates = hn::And(hn::Lt(dot<D>(step, load(last_step_)), real(0)),
                                    hn::Gt(length, hn::Mul(real(0.5F), load(step_length_))));
    const Reals trust_radius = load(trust_radius_);
    store(hn::IfThenElse(oscillates, hn::Mul(real(0.5F), trust_radius), trust_radius), trust_radius_);
    store(moved, x_);
    store(step, last_step_);
    store(length, step_length_);
    return bits_of(to.is_found);
  }

  /// Returns the step with its curvature correction, shortened if the whole exceeds the trust radius.
  HWY_INLINE Vectors corrected(const Projections& to, const Vectors& step) const {
    const Reals available = hn::Sub(hn::Mul(load(trust_radius_), real(r_)), length_of(step));
    const Mask may_grow = hn::Gt(available, real(0));
    if (hn::AllFalse(D(), may_grow)) return step;
    const Vectors more = curvature_correction(to, step);
    const Reals length = length_of(more);
    const Reals part = hn::IfThenElse(hn::Gt(length, available), hn::Div(available, length), real(1));
    return select<D>(may_grow, plus_product(step, part, more), step);
  }

  /// Returns the curvature correction of a step. Balls about edges and corners curve away from their half-spaces:
  /// tangentially to the active contacts, where the curvature is 1 / r, the step is too short by the factor 1 -
  /// multiplier / r (docs/methods/offset_sdf.md#the-steps-to-q).
  HWY_INLINE Vectors curvature_correction(const Projections& to, const Vectors& step) const {
    std::array<Vectors, 2> normals;
    std::array<Features, 2> features;
    std::array<Reals, 2> bends;
    for (std::size_t k = 0; k < 2; ++k) {
      Integers triangle = integer(-1);
      normals[k] = no_vector();
      Vectors point = no_vector();
      for (std::size_t i = 0; i < max_contacts; ++i) {
        const hn::Mask<DI> is_active = hn::Eq(to.contacts[k], integer(static_cast<std::int32_t>(i)));
        triangle = hn::IfThenElse(is_active, load(contacts_[i].triangle), triangle);
        normals[k] = select<D>(of_reals(is_active), load(contacts_[i].normal), normals[k]);
        point = select<D>(of_reals(is_active), load(contacts_[i].point), point);
      }
      features[k] = features_at(records_, triangle, sum(load(origin_), point));
      bends[k] = hn::IfThenZeroElse(features[k].is_face, hn::Mul(to.multipliers[k], real(1 / r_)));
    }
    const auto growth = [](Reals bend) HWY_ATTR {
      constexpr float max_bend = 0.85F;
      return hn::Sub(hn::Div(real(1), hn::Sub(real(1), hn::Min(bend, real(max_bend)))), real(1));
    };
    // One contact: across the edge, or around the corner.
    const Vectors tangential = minus_product<D>(step, dot<D>(normals[0], step), normals[0]);
    const Vectors across = minus_product<D>(tangential, dot<D>(features[0].edge, tangential), features[0].edge);
    const Vectors of_one = product(growth(bends[0]), across);
    // Two: along their crease.
    const Vectors crease = cross(normals[0], normals[1]);
    const Vectors along = product(hn::Div(real(1), hn::Max(length_of(crease), real(1e-20F))), crease);
    Reals bend = real(0);
    for (std::size_t k = 0; k < 2; ++k) {
      const Reals cosine = dot<D>(features[k].edge, along);
      bend = hn::MulAdd(bends[k], hn::NegMulAdd(cosine, cosine, real(1)), bend);
    }
    const Vectors of_two = product(hn::Mul(growth(bend), dot<D>(along, step)), along);
    const Mask has_one = of_reals(hn::Eq(to.count, integer(1)));
    const Mask has_two = of_reals(hn::Eq(to.count, integer(2)));
    return select<D>(has_one, of_one, select<D>(has_two, of_two, no_vector()));
  }

  /// Collects the triangles around x and, close to convergence, those nearest to the contacts.
  void collect_triangles(LaneBits moving) {
    constexpr float nearly_settled = 0.05F;  // of a step's length, in units of r
    const Vectors x = sum(load(origin_), load(x_));
    touches_exterior_ = bits_of(find_cells(exterior_, lowest_cells_around(exterior_, x), others_.data()));
    others_count_ = cells_around_point;
    // On fine meshes the closest triangle is seldom one of the cells' but close to a contact.
    const LaneBits close = moving & bits_of(hn::Lt(load(step_length_), real(nearly_settled * r_)));
    std::array<VectorLanes, max_contacts> places;
    for (std::size_t i = 0; i < max_contacts; ++i) {
      if ((close & contacts_[i].kept) != 0) store(minus_product<D>(x, real(r_), load(contacts_[i].normal)), places[i]);
    }
    for_each_lane(close, [&](std::size_t lane) { collect_near_contacts(lane, places); });
  }

  /// Collects the triangles nearest to the kept contacts of a lane, given places on them, unless they are contacts.
  void collect_near_contacts(std::size_t lane, const std::array<VectorLanes, max_contacts>& places) {
    const Eigen::Vector3d x = origin_.at(lane) + x_.at(lane);
    std::size_t next = cells_around_point;
    for (std::size_t i = 0; i < max_contacts; ++i) {
      if ((contacts_[i].kept >> lane & 1U) == 0) continue;
      const std::int32_t triangle = closest_.closest_near(places[i].at(lane), x);
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
      if (!is_connected_to(exterior_, x, tasks_[task_[lane]].start)) going &= ~(LaneBits{1} << lane);
    });
    const LaneBits found = free & going;
    store(select<D>(mask_of(found), load(x_), load(found_)), found_);
    is_found_ |= found;
    const LaneBits is_settled = found & bits_of(hn::Lt(load(step_length_), real(settled * r_)));
    const Vectors apart = difference(load(known_), load(x_));
    const LaneBits is_known = found & ~is_settled & bits_of(hn::Lt(length_of(apart), real(near_known * r_)));
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

  /// Updates the kept contacts at x, and adds up to two new ones that cover x: the closest, and the closest in another
  /// direction. Returns the lanes with contacts.
  LaneBits renew_contacts() {
    hide_known();
    for (std::size_t i = 0; i < max_contacts; ++i) {
      const Mask is_kept = mask_of(contacts_[i].kept);
      set(contacts_[i], is_kept, at_contacts_[i]);
      remove(contacts_[i], hn::Not(is_kept));
    }
    const Surrounding first = closest_covering(no_vector(), infinity);
    add(first);
    constexpr float same_direction = 0.985F;
    const Mask has_first = is_triangle(load(first.triangle));
    const Reals inverse = hn::IfThenElse(has_first, hn::Div(real(1), hn::Sqrt(load(first.squared))), real(0));
    add(closest_covering(product(inverse, load(first.vector)), same_direction));
    Mask any = no_lane();
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
      store(hn::IfThenElse(of_reals(is_known), real(infinity), load(others_[s].squared)), others_[s].squared);
    }
  }

  /// Returns the closest of the other triangles that cover x, of those whose direction has at most this cosine with
  /// another one.
  HWY_INLINE Surrounding closest_covering(const Vectors& direction, float max_cosine) const {
    Reals least = real(covering() * covering());
    Vectors closest = no_vector();
    Integers number = integer(-1);
    for (std::size_t s = 0; s < others_count_; ++s) {
      const Reals squared = load(others_[s].squared);
      const Vectors vector = load(others_[s].vector);
      const Mask is_apart = hn::Le(dot<D>(vector, direction), hn::Mul(real(max_cosine), hn::Sqrt(squared)));
      const Mask is_closer = hn::And(hn::Lt(squared, least), is_apart);
      least = hn::IfThenElse(is_closer, squared, least);
      closest = select<D>(is_closer, vector, closest);
      number = hn::IfThenElse(of_integers(is_closer), load(others_[s].triangle), number);
    }
    Surrounding result;
    store(number, result.triangle);
    store(closest, result.vector);
    store(least, result.squared);
    return result;
  }

  /// Adds a contact where there is room.
  HWY_INLINE void add(const Surrounding& surrounding) {
    Mask waiting = is_triangle(load(surrounding.triangle));
    for (Contact& contact : contacts_) {
      const Mask is_free = hn::AndNot(is_triangle(load(contact.triangle)), waiting);
      if (!hn::AllFalse(D(), is_free)) set(contact, is_free, surrounding);
      waiting = hn::AndNot(is_free, waiting);
    }
  }

  HWY_INLINE void set(Contact& contact, Mask where, const Surrounding& surrounding) const {
    const Vectors x = load(x_);
    const Vectors vector = load(surrounding.vector);
    const Reals distance = hn::Sqrt(load(surrounding.squared));
    const Vectors normal = product(hn::Div(real(1), distance), vector);
    const Reals height = hn::Add(hn::Sub(dot<D>(normal, x), distance), real(r_));
    store(select<D>(where, normal, load(contact.normal)), contact.normal);
    store(select<D>(where, difference(x, vector), load(contact.point)), contact.point);
    store(hn::IfThenElse(where, height, load(contact.height)), contact.height);
    store(hn::IfThenElse(of_integers(where), load(surrounding.triangle), load(contact.triangle)), contact.triangle);
  }

  HWY_INLINE static void remove(Contact& contact, Mask where) {
    store(select<D>(where, no_vector(), load(contact.normal)), contact.normal);
    store(select<D>(where, no_vector(), load(contact.point)), contact.point);
    store(hn::IfThenElse(where, real(no_height), load(contact.height)), contact.height);
    store(hn::IfThenElse(of_integers(where), integer(-1), load(contact.triangle)), contact.triangle);
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
  std::span<OffsetPointTask> tasks_;
  std::size_t next_task_ = 0;
  std::array<std::size_t, max_lanes> task_{};
  std::array<int, max_lanes> steps_{};
  LaneBits active_ = 0;
  LaneBits is_found_ = 0;
  LaneBits is_truncated_ = 0;  ///< the last step was shortened
  LaneBits touches_exterior_ = 0;
  VectorLanes origin_;  ///< p; all other places are relative to it
  VectorLanes x_, found_{}, known_, last_step_;
  RealLanes step_length_;   ///< length of the last step, before it was shortened
  RealLanes trust_radius_;  ///< maximum correction of a step, in units of r
  std::array<Contact, max_contacts> contacts_{};
  std::array<Surrounding, max_contacts> at_contacts_{};
  std::array<Surrounding, cells_around_point + max_contacts> others_{};  ///< around x
  std::size_t others_count_ = 0;
};

void find_points(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetPointTask> tasks) {
  OffsetPointLanes(exterior, closest, tasks).run();
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
