// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic on numbers of one sample (float), or of one sample per lane of the processor's vectors (Highway's
// vectors), for sources compiled for each instruction set supported by Highway. Code written with it, for numbers of
// type V, calls Highway's functions without a namespace: those of vectors are found by their arguments, those of floats
// are here.

#if defined(SHAPEGAUGE_CORE_OFFSET_NUMBERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPEGAUGE_CORE_OFFSET_NUMBERS_INL_H
#undef SHAPEGAUGE_CORE_OFFSET_NUMBERS_INL_H
#else
#define SHAPEGAUGE_CORE_OFFSET_NUMBERS_INL_H
#endif

#include <cmath>
#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Scalar versions of Highway's functions of the same names, for code on numbers of a type V.
HWY_INLINE float MulAdd(float a, float b, float c) { return std::fma(a, b, c); }
HWY_INLINE float NegMulAdd(float a, float b, float c) { return std::fma(-a, b, c); }
HWY_INLINE float Min(float a, float b) { return b < a ? b : a; }
HWY_INLINE float Max(float a, float b) { return a < b ? b : a; }
HWY_INLINE float Sqrt(float a) { return std::sqrt(a); }
HWY_INLINE bool And(bool a, bool b) { return a && b; }
HWY_INLINE bool Or(bool a, bool b) { return a || b; }
HWY_INLINE bool Not(bool a) { return !a; }
HWY_INLINE bool AndNot(bool a, bool b) { return !a && b; }
HWY_INLINE float IfThenElse(bool mask, float a, float b) { return mask ? a : b; }
HWY_INLINE float IfThenZeroElse(bool mask, float a) { return mask ? 0 : a; }

/// Types and functions that belong to a number type V, which is a float or a SIMD vector of floats: masks (one truth
/// value per lane), integers (one per lane), and functions that make and test them.
template <typename V>
struct NumbersOf {
  using D = hn::DFromV<V>;  ///< Highway tag of V
  using Mask = hn::Mask<D>;
  using Integer = hn::Vec<hn::RebindToSigned<D>>;
  static HWY_INLINE V number(float value) { return hn::Set(D(), value); }
  static HWY_INLINE Integer integer(std::int32_t value) { return hn::Set(hn::RebindToSigned<D>(), value); }
  static HWY_INLINE bool all(Mask mask) { return hn::AllTrue(D(), mask); }
  static HWY_INLINE bool none(Mask mask) { return hn::AllFalse(D(), mask); }
  static HWY_INLINE Integer choose(Mask mask, Integer a, Integer b) {
    return hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), mask), a, b);
  }
  static HWY_INLINE Mask is_equal(Integer a, Integer b) { return hn::RebindMask(D(), hn::Eq(a, b)); }
};
template <>
struct NumbersOf<float> {
  using Mask = bool;
  using Integer = std::int32_t;
  static HWY_INLINE float number(float value) { return value; }
  static HWY_INLINE Integer integer(std::int32_t value) { return value; }
  static HWY_INLINE bool all(Mask mask) { return mask; }
  static HWY_INLINE bool none(Mask mask) { return !mask; }
  static HWY_INLINE Integer choose(Mask mask, Integer a, Integer b) { return mask ? a : b; }
  static HWY_INLINE Mask is_equal(Integer a, Integer b) { return a == b; }
};
/// Truth value of numbers V: a bool, or a Highway mask with one truth value per lane.
template <typename V>
using MaskOf = typename NumbersOf<V>::Mask;
template <typename V>
using IntegerOf = typename NumbersOf<V>::Integer;
/// Returns the value as a V, repeated in all lanes.
template <typename V>
HWY_INLINE V number(float value) {
  return NumbersOf<V>::number(value);
}

/// Three-dimensional vector whose components are numbers V.
template <typename V>
struct Vector3 {
  V x, y, z;
};

template <typename V>
HWY_INLINE Vector3<V> zero_vector() {
  return {number<V>(0), number<V>(0), number<V>(0)};
}
template <typename V>
HWY_INLINE V dot(const Vector3<V>& u, const Vector3<V>& v) {
  return MulAdd(u.x, v.x, MulAdd(u.y, v.y, u.z * v.z));
}
template <typename V>
HWY_INLINE V length_of(const Vector3<V>& v) {
  return Sqrt(dot(v, v));
}
template <typename V>
HWY_INLINE Vector3<V> sum(const Vector3<V>& u, const Vector3<V>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <typename V>
HWY_INLINE Vector3<V> difference(const Vector3<V>& u, const Vector3<V>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <typename V>
HWY_INLINE Vector3<V> product(V s, const Vector3<V>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
/// Computes u + s v.
template <typename V>
HWY_INLINE Vector3<V> plus_product(const Vector3<V>& u, V s, const Vector3<V>& v) {
  return {MulAdd(s, v.x, u.x), MulAdd(s, v.y, u.y), MulAdd(s, v.z, u.z)};
}
/// Computes u - s v.
template <typename V>
HWY_INLINE Vector3<V> minus_product(const Vector3<V>& u, V s, const Vector3<V>& v) {
  return {NegMulAdd(s, v.x, u.x), NegMulAdd(s, v.y, u.y), NegMulAdd(s, v.z, u.z)};
}
template <typename V>
HWY_INLINE Vector3<V> cross(const Vector3<V>& u, const Vector3<V>& v) {
  return {NegMulAdd(u.z, v.y, u.y * v.z), NegMulAdd(u.x, v.z, u.z * v.x), NegMulAdd(u.y, v.x, u.x * v.y)};
}
/// Returns u where the mask is set, otherwise v.
template <typename V>
HWY_INLINE Vector3<V> select(MaskOf<V> mask, const Vector3<V>& u, const Vector3<V>& v) {
  return {IfThenElse(mask, u.x, v.x), IfThenElse(mask, u.y, v.y), IfThenElse(mask, u.z, v.z)};
}

}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
