#include "shapegauge/core/spatial/exterior_on_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shapegauge {

namespace {

/// A patch of the sphere: a square of the circumscribed cube's face, seen from the centre.
struct Patch {
  int face;   ///< 0 to 5: axis face % 3, negative side for 3 to 5
  int level;  ///< the face is cut into 2^level columns and as many rows
  int column, row;
  std::int32_t hint;  ///< a triangle that is likely to cover the patch
};

/// What a triangle was found to cover of a patch.
enum class Cover { unknown, middle, all };

/// Patches that reach farther than this, as a fraction of r, are divided rather than looked at closely.
constexpr double large_patch = 0.15;

/// The sphere and what is being looked for on it.
class SphereSearch {
 public:
  SphereSearch(const OffsetExterior& exterior, const Eigen::Vector3d& centre, double radius, double smallest_radius,
               SearchMemory& memory)
      : exterior_(exterior), centre_(centre), radius_(radius), smallest_radius_(smallest_radius), memory_(memory) {}

  std::optional<ExteriorPoint> run() {
    for (int face = 0; face < 6; ++face) split({face, 0, 0, 0, -1}, -1);
    while (!waiting_.empty()) {
      const Patch patch = waiting_.back();
      waiting_.pop_back();
      if (auto found = look_into(patch)) return found;
    }
    return std::nullopt;
  }

 private:
  /// A patch's middle and corners, and the distance from the middle to the farthest corner.
  struct Outline {
    Eigen::Vector3d middle;
    std::array<Eigen::Vector3d, 4> corners;
    double reach = 0;
  };

  [[nodiscard]] Eigen::Vector3d on_sphere(int face, double u, double v) const {
    Eigen::Vector3d direction;
    const int axis = face % 3;
    direction[axis] = face < 3 ? 1 : -1;
    direction[(axis + 1) % 3] = u;
    direction[(axis + 2) % 3] = v;
    return centre_ + radius_ * direction.normalized();
  }

  void split(const Patch& patch, std::int32_t hint) {
    for (int i = 0; i < 4; ++i) {
      waiting_.push_back({patch.face, patch.level + 1, 2 * patch.column + i % 2, 2 * patch.row + i / 2, hint});
    }
  }

  std::optional<ExteriorPoint> look_into(const Patch& patch) {
    const Outline outline = outline_of(patch);
    const bool remembered = patch.level < SearchMemory::levels;
    std::int32_t unused = -1;
    std::int32_t& before =
        remembered ? memory_.covering_triangle(patch.face, patch.level, patch.column, patch.row) : unused;
    for (const std::int32_t triangle : {patch.hint, before}) {
      const Cover cover = cover_by(outline, triangle);
      if (cover == Cover::all) return std::nullopt;
      if (cover == Cover::middle && outline.reach > large_patch * exterior_.r()) {
        if (exterior_.may_hold_exterior(outline.middle, outline.reach)) split(patch, triangle);
        return std::nullopt;
      }
    }
    if (!exterior_.may_hold_exterior(outline.middle, outline.reach)) return std::nullopt;
    const double r = exterior_.r();
    const auto hit = exterior_.tree().closest(outline.middle, r + outline.reach, patch.hint);
    if (hit) before = hit->triangle;
    if (hit && hit->distance < r) {
      if (outline.reach > smallest_radius_ && cover_by(outline, hit->triangle) != Cover::all)
        split(patch, hit->triangle);
      return std::nullopt;
    }
    const auto is_exterior = exterior_.contains(outline.middle);
    if (is_exterior.value_or(true)) return ExteriorPoint{outline.middle, is_exterior.has_value()};
    if (hit && outline.reach > smallest_radius_) split(patch, hit->triangle);
    return std::nullopt;
  }

  [[nodiscard]] Outline outline_of(const Patch& patch) const {
    const double side = 1 << patch.level;
    const double u = (2 * patch.column + 1) / side - 1;
    const double v = (2 * patch.row + 1) / side - 1;
    Outline outline{.middle = on_sphere(patch.face, u, v), .corners = {}};
    for (std::size_t i = 0; i < 4; ++i) {
      const double du = (i & 1) != 0 ? 1 / side : -1 / side;
      const double dv = (i & 2) != 0 ? 1 / side : -1 / side;
      outline.corners[i] = on_sphere(patch.face, u + du, v + dv);
      outline.reach = std::max(outline.reach, (outline.corners[i] - outline.middle).norm());
    }
    return outline;
  }

  /// How much of a patch is within r of the triangle. The points within some distance of a triangle are a convex set:
  /// with the corners it holds their hull, and the patch rises above that by no more than its sagitta.
  [[nodiscard]] Cover cover_by(const Outline& outline, std::int32_t triangle_index) const {
    if (triangle_index < 0) return Cover::unknown;
    const double r = exterior_.r();
    const TriangleDistance squared_distance(exterior_.tree().triangle(triangle_index));
    const double middle = squared_distance(outline.middle);
    if (middle >= r * r) return Cover::unknown;
    const double limit = r - outline.reach;
    if (limit > 0 && middle < limit * limit) return Cover::all;
    const double corner_limit = r - outline.reach * outline.reach / (2 * radius_);
    const bool all = corner_limit > 0 &&
                     std::all_of(outline.corners.begin(), outline.corners.end(),
                                 [&](const auto& x) { return squared_distance(x) < corner_limit * corner_limit; });
    return all ? Cover::all : Cover::middle;
  }

  const OffsetExterior& exterior_;
  Eigen::Vector3d centre_;
  double radius_;
  double smallest_radius_;
  SearchMemory& memory_;
  std::vector<Patch> waiting_;
};

}  // namespace

std::optional<ExteriorPoint> exterior_point_on_sphere(const OffsetExterior& exterior, const Eigen::Vector3d& centre,
                                                      double radius, double smallest_radius, SearchMemory& memory) {
  return SphereSearch(exterior, centre, radius, smallest_radius, memory).run();
}

}  // namespace shapegauge
