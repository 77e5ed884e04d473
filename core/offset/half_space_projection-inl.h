// Projection of points onto intersections of half-spaces, one per lane of the processor's vectors, for sources compiled
// for each instruction set supported by Highway.

#if defined(SHAPEGAUGE_CORE_OFFSET_HALF_SPACE_PROJECTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPEGAUGE_CORE_OFFSET_HALF_SPACE_PROJECTION_INL_H
#undef SHAPEGAUGE_CORE_OFFSET_HALF_SPACE_PROJECTION_INL_H
#else
#define SHAPEGAUGE_CORE_OFFSET_HALF_SPACE_PROJECTION_INL_H
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

#include "shapegauge/core/offset/search_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {

constexpr std::size_t max_contacts = 5;
/// Tolerance of half-spaces, in cells: about 3e-5 r.
constexpr float tolerance = 1e-4F;
/// Height of a half-space that contains everything.
constexpr float no_height = -1e30F;

/// Triangle, -1 if there is none, with the half-space outside the tangent plane of a ball of radius r about one of its
/// points: normal . x >= height.
struct Contact {
  IntegerLanes triangle;
  VectorLanes normal;
  RealLanes height;
  VectorLanes point;  ///< centre of the ball, on the triangle
  LaneBits kept = 0;  ///< retained after the last step
};

/// Projections of p onto half-spaces, with up to two active contacts and their multipliers.
struct Projections {
  Vectors x;
  Mask is_found;  ///< false if the intersection is empty
  Integers count;
  std::array<Reals, 2> multipliers;
  std::array<Integers, 2> contacts;

  // An implicit constructor would not be compiled for the instruction set.
  HWY_INLINE Projections()
      : x(no_vector()),
        is_found(no_lane()),
        count(integer(0)),
        multipliers{real(0), real(0)},
        contacts{integer(0), integer(0)} {}

  HWY_INLINE void set(Mask where, const Vectors& to, std::int32_t active) {
    x = select<D>(where, to, x);
    is_found = hn::Or(is_found, where);
    count = hn::IfThenElse(of_integers(where), integer(active), count);
  }
  HWY_INLINE void set_contact(Mask where, std::size_t k, Integers contact, Reals multiplier) {
    contacts[k] = hn::IfThenElse(of_integers(where), contact, contacts[k]);
    multipliers[k] = hn::IfThenElse(where, multiplier, multipliers[k]);
  }
};

/// Projects p, the origin, onto the intersections of half-spaces. By the Karush-Kuhn-Tucker conditions a projection is
/// the sum of multiplier_i normal_i, with multipliers >= 0 for one, two or three active half-spaces, whose planes
/// contain it, and 0 for the others.
class Projector {
 public:
  HWY_INLINE explicit Projector(const std::array<Contact, max_contacts>& contacts) {
    for (std::size_t i = 0; i < max_contacts; ++i) {
      normals_[i] = load(contacts[i].normal);
      violations_[i] = load(contacts[i].height);
      for (std::size_t j = 0; j < i; ++j) gram_[i][j] = gram_[j][i] = dot<D>(normals_[i], normals_[j]);
    }
  }

  HWY_INLINE Projections find() {
    project_on_worst();
    for (std::size_t i = 0; i < max_contacts; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (hn::AllTrue(D(), result_.is_found)) return result_;
        project_on_two(i, j);
      }
    }
    for (std::size_t i = 0; i < max_contacts; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (hn::AllTrue(D(), result_.is_found)) return result_;
          project_on_three(i, j, k);
        }
      }
    }
    return result_;
  }

 private:
  static constexpr float least_determinant = 1e-5F;

  /// A single active plane can only be the one farthest from p.
  HWY_INLINE void project_on_worst() {
    Reals worst = violations_[0];
    Vectors normal = normals_[0];
    Integers contact = integer(0);
    for (std::size_t i = 1; i < max_contacts; ++i) {
      const Mask is_worse = hn::Gt(violations_[i], worst);
      worst = hn::Max(violations_[i], worst);
      normal = select<D>(is_worse, normals_[i], normal);
      contact = hn::IfThenElse(of_integers(is_worse), integer(static_cast<std::int32_t>(i)), contact);
    }
    result_.is_found = hn::Le(worst, real(tolerance));
    Mask where = hn::Not(result_.is_found);
    for (std::size_t i = 0; i < max_contacts; ++i) {
      const Reals violation = hn::NegMulAdd(worst, dot<D>(normals_[i], normal), violations_[i]);
      where = hn::And(where, hn::Le(violation, real(tolerance)));
    }
    result_.set(where, product(worst, normal), 1);
    result_.set_contact(where, 0, contact, worst);
  }

  HWY_INLINE void project_on_two(std::size_t i, std::size_t j) {
    const Reals gram = gram_[i][j];
    const Reals determinant = hn::NegMulAdd(gram, gram, real(1));
    const Reals mi = hn::Div(hn::NegMulAdd(gram, violations_[j], violations_[i]), determinant);
    const Reals mj = hn::Div(hn::NegMulAdd(gram, violations_[i], violations_[j]), determinant);
    Mask where = unresolved(determinant, hn::Min(mi, mj));
    for (std::size_t k = 0; k < max_contacts; ++k) {
      if (k == i || k == j) continue;
      const Reals violation = hn::NegMulAdd(mj, gram_[k][j], hn::NegMulAdd(mi, gram_[k][i], violations_[k]));
      where = hn::And(where, hn::Le(violation, real(tolerance)));
    }
    if (hn::AllFalse(D(), where)) return;
    result_.set(where, plus_product(product(mj, normals_[j]), mi, normals_[i]), 2);
    result_.set_contact(where, 0, integer(static_cast<std::int32_t>(i)), mi);
    result_.set_contact(where, 1, integer(static_cast<std::int32_t>(j)), mj);
  }

  /// Solves by Cramer's rule.
  HWY_INLINE void project_on_three(std::size_t i, std::size_t j, std::size_t k) {
    const Reals a = gram_[i][j];
    const Reals b = gram_[i][k];
    const Reals c = gram_[j][k];
    const Reals aa = hn::NegMulAdd(a, a, real(1));
    const Reals bb = hn::NegMulAdd(b, b, real(1));
    const Reals cc = hn::NegMulAdd(c, c, real(1));
    const Reals bc = hn::Sub(hn::Mul(b, c), a);
    const Reals ac = hn::Sub(hn::Mul(a, c), b);
    const Reals ab = hn::Sub(hn::Mul(a, b), c);
    const Reals determinant = hn::MulAdd(b, ac, hn::MulAdd(a, bc, cc));
    const Vectors v{violations_[i], violations_[j], violations_[k]};
    const Reals mi = hn::Div(dot<D>({cc, bc, ac}, v), determinant);
    const Reals mj = hn::Div(dot<D>({bc, bb, ab}, v), determinant);
    const Reals mk = hn::Div(dot<D>({ac, ab, aa}, v), determinant);
    Mask where = unresolved(determinant, hn::Min(mi, hn::Min(mj, mk)));
    if (hn::AllFalse(D(), where)) return;
    for (std::size_t m = 0; m < max_contacts; ++m) {
      if (m == i || m == j || m == k) continue;
      const Vectors gram{gram_[m][i], gram_[m][j], gram_[m][k]};
      where = hn::And(where, hn::Le(hn::Sub(violations_[m], dot<D>({mi, mj, mk}, gram)), real(tolerance)));
    }
    const Vectors x = plus_product(plus_product(product(mk, normals_[k]), mj, normals_[j]), mi, normals_[i]);
    result_.set(where, x, 3);
  }

  /// Returns the lanes without a projection whose system is regular, with multipliers that are not negative.
  HWY_INLINE Mask unresolved(Reals determinant, Reals least_multiplier) const {
    const Mask is_solution = hn::And(hn::Ge(determinant, real(least_determinant)), hn::Ge(least_multiplier, real(0)));
    return hn::AndNot(result_.is_found, is_solution);
  }

  std::array<Vectors, max_contacts> normals_;
  std::array<Reals, max_contacts> violations_;
  std::array<std::array<Reals, max_contacts>, max_contacts> gram_;
  Projections result_;
};

}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
