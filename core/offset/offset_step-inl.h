// SPDX-License-Identifier: GPL-3.0-or-later
// One step of the iteration to q (docs/methods/offset_sdf.md#the-steps-to-q): the projection of p onto the half-spaces
// of the contacts, and its curvature correction. For numbers V of one sample, or of one per lane (numbers-inl.h); for
// sources compiled for each instruction set supported by Highway.

#if defined(SHAPEGAUGE_CORE_OFFSET_OFFSET_STEP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPEGAUGE_CORE_OFFSET_OFFSET_STEP_INL_H
#undef SHAPEGAUGE_CORE_OFFSET_OFFSET_STEP_INL_H
#else
#define SHAPEGAUGE_CORE_OFFSET_OFFSET_STEP_INL_H
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

#include "shapegauge/core/offset/numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {

constexpr std::size_t max_contacts = 5;  ///< maximum number of half-spaces in a step of the iteration
/// Distance from a half-space up to which a point counts as inside, in cells: about 3e-5 r.
constexpr float tolerance = 1e-4F;
/// Value of HalfSpace::height for a half-space that contains all points.
constexpr float unbounded_height = -1e30F;

/// Half-space of all points x with normal . x >= height. The normal has unit length.
template <typename V>
struct HalfSpace {
  Vector3<V> normal;
  V height;  ///< signed distance of the boundary plane from the origin
};

/// Returns the half-space that is tangent, on the side of x, to the ball of radius r about the point of a triangle
/// closest to x, and does not contain the ball. `vector` leads from that point to x and has the length `length`.
template <typename V>
HWY_INLINE HalfSpace<V> tangent_half_space(const Vector3<V>& x, const Vector3<V>& vector, V length, float r) {
  const Vector3<V> normal = product(number<V>(1) / length, vector);
  return {normal, dot(normal, x) - length + number<V>(r)};
}

/// Projection of p, the origin, onto the intersection of half-spaces. By the Karush-Kuhn-Tucker conditions it is the
/// sum of push_i normal_i, with push_i >= 0 for one, two or three active half-spaces, whose planes contain it, and 0
/// for the others.
template <typename V>
struct Projection {
  Vector3<V> x;                          ///< projected point
  MaskOf<V> is_found;                    ///< false if the intersection is empty
  IntegerOf<V> count;                    ///< number of active half-spaces, 0 to 3
  std::array<V, 2> pushes;               ///< multipliers push_i of the active half-spaces, if one or two are active
  std::array<IntegerOf<V>, 2> contacts;  ///< indices of the active half-spaces, if one or two are active

  // An implicit constructor would not be compiled for the instruction set.
  HWY_INLINE Projection()
      : x(zero_vector<V>()),
        is_found(number<V>(0) < number<V>(0)),
        count(NumbersOf<V>::integer(0)),
        pushes{number<V>(0), number<V>(0)},
        contacts{NumbersOf<V>::integer(0), NumbersOf<V>::integer(0)} {}

  /// In the lanes `where`, sets the projected point and the number of active half-spaces.
  HWY_INLINE void set(MaskOf<V> where, const Vector3<V>& to, std::int32_t active) {
    x = select(where, to, x);
    is_found = Or(is_found, where);
    count = NumbersOf<V>::choose(where, NumbersOf<V>::integer(active), count);
  }
  /// In the lanes `where`, sets the index and the multiplier push_k of the k-th active half-space.
  HWY_INLINE void set_contact(MaskOf<V> where, std::size_t k, IntegerOf<V> contact, V push) {
    contacts[k] = NumbersOf<V>::choose(where, contact, contacts[k]);
    pushes[k] = IfThenElse(where, push, pushes[k]);
  }
};

/// Projects p, the origin, onto the intersection of half-spaces.
template <typename V>
class Projector {
 public:
  using Numbers = NumbersOf<V>;
  using Mask = MaskOf<V>;

  HWY_INLINE explicit Projector(const std::array<HalfSpace<V>, max_contacts>& half_spaces) {
    for (std::size_t i = 0; i < max_contacts; ++i) {
      normals_[i] = half_spaces[i].normal;
      heights_[i] = half_spaces[i].height;
      for (std::size_t j = 0; j < i; ++j) gram_[i][j] = gram_[j][i] = dot(normals_[i], normals_[j]);
    }
  }

  /// Tries one, then all pairs, then all triples of half-spaces as the active ones, until one is a solution.
  HWY_INLINE Projection<V> find() {
    project_on_worst();
    for (std::size_t i = 0; i < max_contacts; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (Numbers::all(result_.is_found)) return result_;
        project_on_two(i, j);
      }
    }
    for (std::size_t i = 0; i < max_contacts; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (Numbers::all(result_.is_found)) return result_;
          project_on_three(i, j, k);
        }
      }
    }
    return result_;
  }

 private:
  static constexpr float min_determinant = 1e-5F;  ///< Gram determinants below this count as singular

  /// Projects p onto one half-space, the one from which it is farthest: no other can be the only active one.
  HWY_INLINE void project_on_worst() {
    V worst = heights_[0];
    Vector3<V> normal = normals_[0];
    IntegerOf<V> contact = Numbers::integer(0);
    for (std::size_t i = 1; i < max_contacts; ++i) {
      const Mask is_worse = heights_[i] > worst;
      worst = Max(heights_[i], worst);
      normal = select(is_worse, normals_[i], normal);
      contact = Numbers::choose(is_worse, Numbers::integer(static_cast<std::int32_t>(i)), contact);
    }
    result_.is_found = worst <= number<V>(tolerance);
    Mask where = Not(result_.is_found);
    for (std::size_t i = 0; i < max_contacts; ++i) {
      where = And(where, is_satisfied(NegMulAdd(worst, dot(normals_[i], normal), heights_[i])));
    }
    result_.set(where, product(worst, normal), 1);
    result_.set_contact(where, 0, contact, worst);
  }

  /// Projects p onto the intersection of two planes.
  HWY_INLINE void project_on_two(std::size_t i, std::size_t j) {
    const V gram = gram_[i][j];
    const V determinant = NegMulAdd(gram, gram, number<V>(1));
    const V push_i = NegMulAdd(gram, heights_[j], heights_[i]) / determinant;
    const V push_j = NegMulAdd(gram, heights_[i], heights_[j]) / determinant;
    Mask where = unresolved(determinant, Min(push_i, push_j));
    for (std::size_t k = 0; k < max_contacts; ++k) {
      if (k == i || k == j) continue;
      where = And(where, is_satisfied(NegMulAdd(push_j, gram_[k][j], NegMulAdd(push_i, gram_[k][i], heights_[k]))));
    }
    if (Numbers::none(where)) return;
    result_.set(where, plus_product(product(push_j, normals_[j]), push_i, normals_[i]), 2);
    result_.set_contact(where, 0, Numbers::integer(static_cast<std::int32_t>(i)), push_i);
    result_.set_contact(where, 1, Numbers::integer(static_cast<std::int32_t>(j)), push_j);
  }

  /// Projects p onto the intersection of three planes, by Cramer's rule.
  HWY_INLINE void project_on_three(std::size_t i, std::size_t j, std::size_t k) {
    const V one = number<V>(1);
    const V a = gram_[i][j];
    const V b = gram_[i][k];
    const V c = gram_[j][k];
    const V aa = NegMulAdd(a, a, one);
    const V bb = NegMulAdd(b, b, one);
    const V cc = NegMulAdd(c, c, one);
    const V bc = b * c - a;
    const V ac = a * c - b;
    const V ab = a * b - c;
    const V determinant = MulAdd(b, ac, MulAdd(a, bc, cc));
    const Vector3<V> heights{heights_[i], heights_[j], heights_[k]};
    const V push_i = dot<V>({cc, bc, ac}, heights) / determinant;
    const V push_j = dot<V>({bc, bb, ab}, heights) / determinant;
    const V push_k = dot<V>({ac, ab, aa}, heights) / determinant;
    Mask where = unresolved(determinant, Min(push_i, Min(push_j, push_k)));
    if (Numbers::none(where)) return;
    for (std::size_t m = 0; m < max_contacts; ++m) {
      if (m == i || m == j || m == k) continue;
      const Vector3<V> gram{gram_[m][i], gram_[m][j], gram_[m][k]};
      where = And(where, is_satisfied(heights_[m] - dot<V>({push_i, push_j, push_k}, gram)));
    }
    const Vector3<V> of_two = plus_product(product(push_k, normals_[k]), push_j, normals_[j]);
    result_.set(where, plus_product(of_two, push_i, normals_[i]), 3);
  }

  HWY_INLINE Mask is_satisfied(V violation) const { return violation <= number<V>(tolerance); }

  /// Returns the lanes without a projection yet where the system is regular and no multiplier is negative.
  HWY_INLINE Mask unresolved(V determinant, V min_push) const {
    const Mask is_solution = And(determinant >= number<V>(min_determinant), min_push >= number<V>(0));
    return AndNot(result_.is_found, is_solution);
  }

  std::array<Vector3<V>, max_contacts> normals_;
  std::array<V, max_contacts> heights_;  ///< distance of p from each half-space; negative inside
  std::array<std::array<V, max_contacts>, max_contacts> gram_;
  Projection<V> result_;
};

/// Feature of a triangle that contains a point: its face, an edge or a corner.
template <typename V>
struct Feature {
  MaskOf<V> is_face;  ///< true if the point is in the interior of the face
  Vector3<V> edge;    ///< unit direction of the edge; zero at a corner
};

/// Returns the feature that contains a point of a triangle, given the triangle's record (TriangleTable::Record).
template <typename V>
HWY_INLINE Feature<V> feature_at(const V* record, const Vector3<V>& point) {
  const V inside = number<V>(1e-3F);
  const Vector3<V> from_a = difference(point, {record[0], record[1], record[2]});
  const Vector3<V> ab{record[3], record[4], record[5]};
  const Vector3<V> ac{record[6], record[7], record[8]};
  const V v = dot(from_a, {record[9], record[10], record[11]});
  const V w = dot(from_a, {record[12], record[13], record[14]});
  // NaN, for a degenerate triangle, counts as on all three edges.
  const MaskOf<V> off_ab = w > inside;
  const MaskOf<V> off_ac = v > inside;
  const MaskOf<V> off_bc = number<V>(1) - (v + w) > inside;
  const MaskOf<V> is_on_edge = Or(And(off_ab, Or(off_ac, off_bc)), And(off_ac, off_bc));
  const Vector3<V> edge = select(off_ab, select(off_ac, difference(ac, ab), ac), ab);
  const Vector3<V> direction = product(number<V>(1) / length_of(edge), edge);
  return {And(off_ab, And(off_ac, off_bc)), select(is_on_edge, direction, zero_vector<V>())};
}

/// Active half-space of a projection: its normal, and the feature (face, edge or corner) of the triangle that contains
/// the centre of its ball.
template <typename V>
struct ActiveContact {
  Vector3<V> normal;
  Feature<V> feature;
};

/// Returns the curvature correction, a vector to be added to a step. Balls about edges and corners curve away from
/// their half-spaces: tangentially to the active contacts, where the curvature is 1 / r, the step is too short by the
/// factor 1 - push / r.
template <typename V>
HWY_INLINE Vector3<V> curvature_correction(const Projection<V>& to, const std::array<ActiveContact<V>, 2>& contacts,
                                           const Vector3<V>& step, float r) {
  const auto growth = [](V bend) HWY_ATTR {
    constexpr float max_bend = 0.85F;
    return number<V>(1) / (number<V>(1) - Min(bend, number<V>(max_bend))) - number<V>(1);
  };
  std::array<V, 2> bends;
  for (std::size_t k = 0; k < 2; ++k) {
    bends[k] = IfThenZeroElse(contacts[k].feature.is_face, to.pushes[k] * number<V>(1 / r));
  }
  // One contact: across the edge, or around the corner.
  const Vector3<V>& normal = contacts[0].normal;
  const Vector3<V>& edge = contacts[0].feature.edge;
  const Vector3<V> tangential = minus_product(step, dot(normal, step), normal);
  const Vector3<V> across = minus_product(tangential, dot(edge, tangential), edge);
  const Vector3<V> of_one = product(growth(bends[0]), across);
  // Two: along their crease.
  const Vector3<V> crease = cross(normal, contacts[1].normal);
  const Vector3<V> along = product(number<V>(1) / Max(length_of(crease), number<V>(1e-20F)), crease);
  V bend = number<V>(0);
  for (std::size_t k = 0; k < 2; ++k) {
    const V cosine = dot(contacts[k].feature.edge, along);
    bend = MulAdd(bends[k], NegMulAdd(cosine, cosine, number<V>(1)), bend);
  }
  const Vector3<V> of_two = product(growth(bend) * dot(along, step), along);
  const MaskOf<V> has_one = NumbersOf<V>::is_equal(to.count, NumbersOf<V>::integer(1));
  const MaskOf<V> has_two = NumbersOf<V>::is_equal(to.count, NumbersOf<V>::integer(2));
  return select(has_one, of_one, select(has_two, of_two, zero_vector<V>()));
}

}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
