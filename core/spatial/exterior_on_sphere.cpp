#include "shapegauge/core/spatial/exterior_on_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shapegauge/core/spatial/patch_quad.h"

namespace shapegauge {

namespace {

/// Patches that reach farther than this, as a fraction of r, are divided rather than looked at closely.
constexpr double large_patch = 0.15;
/// What single precision may lose of a distance, as a fraction of r.
constexpr double rounding = 1e-5;

/// A square of the circumscribed cube's face, seen from the centre: a patch of the sphere that is to be divided.
struct Square {
  int face;   ///< 0 to 5: axis face % 3, negative side for 3 to 5
  int level;  ///< the face is cut into 2^level columns and as many rows
  int column, row;
  std::int32_t hint;  ///< a triangle that is likely to cover the patch
};

/// The sphere and what is being looked for on it.
class SphereSearch {
 public:
  SphereSearch(const OffsetExterior& exterior, const Eigen::Vector3d& centre, double radius, double smallest_radius,
               SearchMemory& memory)
      : exterior_(exterior), centre_(centre), radius_(radius), smallest_radius_(smallest_radius), memory_(memory) {}

  SphereFinding run() {
    for (int face = 0; face < 6; ++face) waiting_.push_back({face, 0, 0, 0, -1});
    while (!waiting_.empty()) {
      const Square square = waiting_.back();
      waiting_.pop_back();
      if (const auto found = look_into(square)) return {found, decided_};
    }
    return {std::nullopt, decided_};
  }

 private:
  /// The four quarters of a square while they are looked at.
  struct Quarters {
    Square square;
    PatchQuad quad;
    double reach = 0;  ///< no point of a quarter is farther than this from its middle
    std::array<bool, 4> is_covered{};
    std::array<bool, 4> middle_is_covered{};
  };

  std::optional<Eigen::Vector3d> look_into(const Square& square) {
    Quarters quarters = quarters_of(square);
    cover(quarters, square.hint);
    for (int i = 0; i < 4; ++i) {
      if (quarters.is_covered[static_cast<std::size_t>(i)]) continue;
      if (auto found = look_into(quarters, i)) return found;
    }
    return std::nullopt;
  }

  std::optional<Eigen::Vector3d> look_into(Quarters& quarters, int i) {
    const auto quarter = static_cast<std::size_t>(i);
    const Square& parent = quarters.square;
    Square patch{parent.face, parent.level + 1, 2 * parent.column + i % 2, 2 * parent.row + i / 2, parent.hint};
    const Eigen::Vector3d middle = centre_ + quarters.quad.point(PatchQuad::middle_lane[quarter]);
    std::int32_t unused = -1;
    std::int32_t& before = patch.level < SearchMemory::levels
                               ? memory_.covering_triangle(patch.face, patch.level, patch.column, patch.row)
                               : unused;
    cover(quarters, before);
    for (std::size_t k = 0; k < recent_.size() && !quarters.is_covered[quarter]; ++k) cover(quarters, recent_[k]);
    if (quarters.is_covered[quarter]) return std::nullopt;
    const bool is_large = quarters.reach > large_patch * exterior_.r();
    if (is_large ? !exterior_.may_hold_exterior(middle, quarters.reach) : exterior_.is_among_enclosed(middle)) {
      return std::nullopt;
    }
    if (quarters.middle_is_covered[quarter] && is_large) {
      waiting_.push_back(patch);
      return std::nullopt;
    }
    return look_closely(quarters, quarter, patch, middle, before);
  }

  std::optional<Eigen::Vector3d> look_closely(Quarters& quarters, std::size_t quarter, Square patch,
                                              const Eigen::Vector3d& middle, std::int32_t& before) {
    const double r = exterior_.r();
    const auto hit = exterior_.tree().closest(middle, r + quarters.reach, patch.hint);
    if (hit) before = patch.hint = recent_[oldest_++ % recent_.size()] = hit->triangle;
    if (!hit || hit->distance >= r) {
      const auto is_exterior = exterior_.contains(middle);
      decided_ &= is_exterior.has_value();
      if (is_exterior == true) return middle;
      if (!hit) return std::nullopt;
    } else {
      cover(quarters, hit->triangle);
    }
    if (!quarters.is_covered[quarter] && quarters.reach > smallest_radius_) waiting_.push_back(patch);
    return std::nullopt;
  }

  [[nodiscard]] Quarters quarters_of(const Square& square) const {
    const double half = 1.0 / (1 << square.level);
    const double u = (2 * square.column + 1) * half - 1;
    const double v = (2 * square.row + 1) * half - 1;
    // Going from the cube's face to the sphere shrinks lengths by the distance from the centre, or more.
    const double shrinking =
        Eigen::Vector3d(1, std::max(std::abs(u) - half, 0.0), std::max(std::abs(v) - half, 0.0)).norm();
    const double reach = radius_ * std::sqrt(0.5) * half / shrinking;
    return {square, patch_quad(radius_, square.face, u, v, half), reach, {}, {}};
  }

  /// Marks the quarters of which all is within r of the triangle. The points within some distance of a triangle are a
  /// convex set: with the corners it holds their hull, and the patch rises above that by no more than its sagitta.
  void cover(Quarters& quarters, std::int32_t triangle_index) const {
    if (triangle_index < 0) return;
    Triangle triangle = exterior_.tree().triangle(triangle_index);
    for (Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c}) *corner -= centre_;
    const auto distances = squared_distances(quarters.quad, triangle);
    const double r = exterior_.r() * (1 - rounding);
    const double from_middle = std::max(0.0, r - quarters.reach);
    const double from_corners = std::max(0.0, r - quarters.reach * quarters.reach / (2 * radius_));
    const auto is_within = [&](int lane, double limit) {
      return static_cast<double>(distances[static_cast<std::size_t>(lane)]) < limit * limit;
    };
    for (std::size_t i = 0; i < 4; ++i) {
      const int middle = PatchQuad::middle_lane[i];
      if (!is_within(middle, r)) continue;
      quarters.middle_is_covered[i] = true;
      const auto& corners = PatchQuad::corner_lanes[i];
      if (is_within(middle, from_middle) ||
          std::all_of(corners.begin(), corners.end(), [&](int lane) { return is_within(lane, from_corners); })) {
        quarters.is_covered[i] = true;
      }
    }
  }

  const OffsetExterior& exterior_;
  Eigen::Vector3d centre_;
  double radius_;
  double smallest_radius_;
  SearchMemory& memory_;
  std::vector<Square> waiting_;
  bool decided_ = true;
  std::array<std::int32_t, 4> recent_ = {-1, -1, -1, -1};  ///< the triangles that were last found to be closest
  std::size_t oldest_ = 0;
};

}  // namespace

SphereFinding exterior_point_on_sphere(const OffsetExterior& exterior, const Eigen::Vector3d& centre, double radius,
                                       double smallest_radius, SearchMemory& memory) {
  return SphereSearch(exterior, centre, radius, smallest_radius, memory).run();
}

}  // namespace shapegauge
