// Loop over triangles, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/triangle_table.cpp"
#include "shapegauge/core/offset/triangle_table.h"

#include <Eigen/Geometry>
#include <cmath>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Loads sixteen numbers of each of four or eight records as sixteen vectors: loads groups of four numbers and
/// transposes them within 128-bit lanes. Faster than gathering.
template <typename D>
HWY_INLINE void load_transposed(D d, const float* records, const std::int32_t* numbers, hn::Vec<D>* fields) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < 16; ++i) fields[i] = hn::Set(d, records[16 * static_cast<std::size_t>(numbers[0]) + i]);
#else
  const hn::RepartitionToWide<D> wide;
  for (std::size_t group = 0; group < 4; ++group) {
    const auto row = [&](std::size_t i) {
      const hn::FixedTag<float, 4> quarter;
      const auto at = [&](std::size_t k) {
        return hn::Load(quarter, records + 16 * static_cast<std::size_t>(numbers[k]) + 4 * group);
      };
      if constexpr (hn::MaxLanes(d) == 8) {
        return hn::Combine(d, at(4 + i), at(i));
      } else {
        return at(i);
      }
    };
    const auto r0 = row(0);
    const auto r1 = row(1);
    const auto r2 = row(2);
    const auto r3 = row(3);
    const auto low01 = hn::BitCast(wide, hn::InterleaveLower(d, r0, r1));
    const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(d, r0, r1));
    const auto low23 = hn::BitCast(wide, hn::InterleaveLower(d, r2, r3));
    const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(d, r2, r3));
    fields[4 * group] = hn::BitCast(d, hn::InterleaveLower(wide, low01, low23));
    fields[4 * group + 1] = hn::BitCast(d, hn::InterleaveUpper(wide, low01, low23));
    fields[4 * group + 2] = hn::BitCast(d, hn::InterleaveLower(wide, high01, high23));
    fields[4 * group + 3] = hn::BitCast(d, hn::InterleaveUpper(wide, high01, high23));
  }
#endif
}

template <typename D>
struct LaneVectors {
  hn::Vec<D> x, y, z;
};

template <typename D>
hn::Vec<D> dot(const LaneVectors<D>& u, const LaneVectors<D>& v) {
  return hn::MulAdd(u.x, v.x, hn::MulAdd(u.y, v.y, hn::Mul(u.z, v.z)));
}

/// Computes u - v b for scalars v.
template <typename D>
LaneVectors<D> minus_product(const LaneVectors<D>& u, hn::Vec<D> v, const LaneVectors<D>& b) {
  return {hn::NegMulAdd(v, b.x, u.x), hn::NegMulAdd(v, b.y, u.y), hn::NegMulAdd(v, b.z, u.z)};
}

/// Shortest of a sequence of vectors, with its squared length.
template <typename D>
class ShortestVector {
 public:
  explicit ShortestVector(const LaneVectors<D>& first) : vector_(first), squared_(dot<D>(first, first)) {}

  void consider(const LaneVectors<D>& other) {
    const hn::Vec<D> squared = dot<D>(other, other);
    keep(other, squared, hn::Lt(squared, squared_));
  }

  /// Considers the vector in the selected lanes only.
  void consider(const LaneVectors<D>& other, hn::Mask<D> selected) {
    const hn::Vec<D> squared = dot<D>(other, other);
    keep(other, squared, hn::And(selected, hn::Lt(squared, squared_)));
  }

  void store(D d, TriangleTable::Vectors& points, std::size_t lane) const {
    hn::Store(vector_.x, d, points.x.data() + lane);
    hn::Store(vector_.y, d, points.y.data() + lane);
    hn::Store(vector_.z, d, points.z.data() + lane);
    hn::Store(squared_, d, points.squared.data() + lane);
  }

 private:
  void keep(const LaneVectors<D>& other, hn::Vec<D> squared, hn::Mask<D> where) {
    vector_.x = hn::IfThenElse(where, other.x, vector_.x);
    vector_.y = hn::IfThenElse(where, other.y, vector_.y);
    vector_.z = hn::IfThenElse(where, other.z, vector_.z);
    squared_ = hn::IfThenElse(where, squared, squared_);
  }

  LaneVectors<D> vector_;
  hn::Vec<D> squared_;
};

/// Computes the vectors from the closest points of triangles to query points. places_at(d, lane) returns a vector of
/// query points.
template <typename PlacesAt>
HWY_INLINE void vectors_to_places(const float* records, const std::int32_t* triangles, const PlacesAt& places_at,
                                  TriangleTable::Vectors& vectors) {
  const hn::CappedTag<float, TriangleTable::batch_size> d;
  using D = decltype(d);
  using Lanes = hn::Vec<D>;
  const Lanes zero = hn::Zero(d);
  const Lanes one = hn::Set(d, 1.0F);
  const Lanes tiny = hn::Set(d, 1e-30F);  // edges of no length are points: nothing is divided by zero
  const auto clamp = [&](Lanes t) { return hn::Min(hn::Max(t, zero), one); };
  for (std::size_t lane = 0; lane < TriangleTable::batch_size; lane += hn::Lanes(d)) {
    Lanes field[16];
    load_transposed(d, records, triangles + lane, field);
    const auto place = places_at(d, lane);
    const LaneVectors<D> a{hn::Sub(place.x, field[0]), hn::Sub(place.y, field[1]), hn::Sub(place.z, field[2])};
    const LaneVectors<D> ab{field[3], field[4], field[5]};
    const LaneVectors<D> ac{field[6], field[7], field[8]};
    const Lanes along_ab = dot<D>(a, ab);
    const Lanes along_ac = dot<D>(a, ac);
    const Lanes ab2 = dot<D>(ab, ab);
    // x - a - v ab - w ac, for the coordinates v and w of a point of the triangle.
    const auto rest = [&](Lanes v, Lanes w) { return minus_product<D>(minus_product<D>(a, w, ac), v, ab); };
    ShortestVector<D> shortest(rest(clamp(hn::Div(along_ab, hn::Max(ab2, tiny))), zero));
    shortest.consider(rest(zero, clamp(hn::Div(along_ac, hn::Max(dot<D>(ac, ac), tiny)))));
    // (x - b) . bc = (x - a) . (ac - ab) - ab . (ac - ab)
    const Lanes along_bc = hn::Add(hn::Sub(along_ac, along_ab), hn::Sub(ab2, dot<D>(ab, ac)));
    const Lanes t = clamp(hn::Mul(along_bc, field[15]));
    shortest.consider(rest(hn::Sub(one, t), t));
    const Lanes v = dot<D>(a, {field[9], field[10], field[11]});
    const Lanes w = dot<D>(a, {field[12], field[13], field[14]});
    shortest.consider(rest(v, w), hn::And(hn::And(hn::Ge(v, zero), hn::Ge(w, zero)), hn::Le(hn::Add(v, w), one)));
    shortest.store(d, vectors, lane);
  }
}

void vectors_to_one(const float* records, const std::int32_t* triangles, const Eigen::Vector3f& x,
                    TriangleTable::Vectors& vectors) {
  const auto same_for_all = [&](auto d, std::size_t /*lane*/) HWY_ATTR {
    return LaneVectors<decltype(d)>{hn::Set(d, x.x()), hn::Set(d, x.y()), hn::Set(d, x.z())};
  };
  vectors_to_places(records, triangles, same_for_all, vectors);
}

/// Replaces the points.
void vectors_to_each_of(const float* records, const std::int32_t* triangles, TriangleTable::Vectors& points) {
  const auto at = [&](auto d, std::size_t lane) HWY_ATTR {
    return LaneVectors<decltype(d)>{hn::Load(d, points.x.data() + lane), hn::Load(d, points.y.data() + lane),
                                    hn::Load(d, points.z.data() + lane)};
  };
  vectors_to_places(records, triangles, at, points);
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(vectors_to_one);
HWY_EXPORT(vectors_to_each_of);

void TriangleTable::resize(std::size_t count) { records_.resize(count); }

void TriangleTable::set(std::size_t index, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                        const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a;
  const Eigen::Vector3f ac = c - a;
  // (x - a) . dual_b and (x - a) . dual_c are the coordinates v and w of x. They are NaN for a degenerate triangle,
  // which therefore contains no point.
  const Eigen::Vector3d normal = ab.cast<double>().cross(ac.cast<double>());
  const double normal2 = normal.squaredNorm();
  Eigen::Vector3f dual_b = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  Eigen::Vector3f dual_c = dual_b;
  if (normal2 > 0) {
    dual_b = (ac.cast<double>().cross(normal) / normal2).cast<float>();
    dual_c = (normal.cross(ab.cast<double>()) / normal2).cast<float>();
  }
  const float bc2 = (c - b).squaredNorm();
  const float inverse_bc2 = bc2 > 1e-30F ? 1 / bc2 : 0;
  records_[index] = {{a.x(), a.y(), a.z(), ab.x(), ab.y(), ab.z(), ac.x(), ac.y(), ac.z(), dual_b.x(), dual_b.y(),
                      dual_b.z(), dual_c.x(), dual_c.y(), dual_c.z(), inverse_bc2}};
}

void TriangleTable::vectors_to(const Eigen::Vector3d& x, const std::int32_t* triangles, Vectors& result) const {
  HWY_DYNAMIC_DISPATCH(vectors_to_one)(records_.front().data(), triangles, x.cast<float>(), result);
}

double TriangleTable::squared_distance(const Eigen::Vector3d& x, std::int32_t triangle) const {
  std::array<std::int32_t, batch_size> triangles;
  triangles.fill(triangle);
  Vectors vectors;
  vectors_to(x, triangles.data(), vectors);
  return static_cast<double>(vectors.squared[0]);
}

bool TriangleTable::is_over_face(const Eigen::Vector3d& x, std::int32_t triangle, double at_most) const {
  const Record& record = records_[static_cast<std::size_t>(triangle)];
  const auto field = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(record.data() + i); };
  const Eigen::Vector3f from_a = x.cast<float>() - field(0);
  const float v = field(9).dot(from_a);
  const float w = field(12).dot(from_a);
  if (!(v >= 0 && w >= 0 && v + w <= 1)) return false;
  return static_cast<double>((from_a - v * field(3) - w * field(6)).squaredNorm()) <= at_most * at_most;
}

TriangleTable::Feature TriangleTable::feature_at(const Eigen::Vector3d& point, std::int32_t triangle) const {
  constexpr float inside = 1e-3F;
  const Record& record = records_[static_cast<std::size_t>(triangle)];
  const auto field = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(record.data() + i); };
  const Eigen::Vector3f from_a = point.cast<float>() - field(0);
  const float v = field(9).dot(from_a);
  const float w = field(12).dot(from_a);
  // NaN, for a degenerate triangle, counts as on all three edges.
  const bool on_ab = !(w > inside);
  const bool on_ac = !(v > inside);
  const bool on_bc = !(1 - v - w > inside);
  const int edges = static_cast<int>(on_ab) + static_cast<int>(on_ac) + static_cast<int>(on_bc);
  if (edges == 0) return {Part::face, Eigen::Vector3d::Zero()};
  if (edges > 1) return {Part::corner, Eigen::Vector3d::Zero()};
  Eigen::Vector3f edge = field(6) - field(3);
  if (on_ab) edge = field(3);
  if (on_ac) edge = field(6);
  return {Part::edge, edge.cast<double>().normalized()};
}

void TriangleTable::vectors_to_each(Vectors& points, const std::int32_t* triangles) const {
  HWY_DYNAMIC_DISPATCH(vectors_to_each_of)(records_.front().data(), triangles, points);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
