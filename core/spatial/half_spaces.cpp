#include "shapegauge/core/spatial/half_spaces.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace shapegauge {

namespace {

/// Planes whose normals are closer to dependent than this have no trustworthy common point.
constexpr double smallest_determinant = 1e-8;

/// The closest candidate so far that satisfies all of the half-spaces.
class Best {
 public:
  Best(std::span<const HalfSpace> half_spaces, const Eigen::Vector3d& p) : half_spaces_(half_spaces), p_(p) {}

  void offer(const Eigen::Vector3d& x) {
    const double distance2 = (x - p_).squaredNorm();
    if (!(distance2 < distance2_)) return;
    const double slack = 1e-9 * std::sqrt(distance2);
    for (const HalfSpace& half_space : half_spaces_) {
      if (half_space.normal.dot(x) < half_space.bound - slack) return;
    }
    distance2_ = distance2;
    x_ = x;
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> point() const {
    return std::isfinite(distance2_) ? std::optional(x_) : std::nullopt;
  }

 private:
  std::span<const HalfSpace> half_spaces_;
  Eigen::Vector3d p_;
  Eigen::Vector3d x_ = Eigen::Vector3d::Zero();
  double distance2_ = std::numeric_limits<double>::infinity();
};

/// The point closest to p on all of the planes that bound the half-spaces (two or three of them).
template <int n>
std::optional<Eigen::Vector3d> closest_on_planes(const std::array<const HalfSpace*, n>& planes,
                                                 const Eigen::Vector3d& p) {
  Eigen::Matrix<double, n, 3> normals;
  Eigen::Matrix<double, n, 1> missing;
  for (int i = 0; i < n; ++i) {
    const HalfSpace& plane = *planes[static_cast<std::size_t>(i)];
    normals.row(i) = plane.normal;
    missing[i] = plane.bound - plane.normal.dot(p);
  }
  const Eigen::Matrix<double, n, n> gram = normals * normals.transpose();
  if (!(gram.determinant() > smallest_determinant)) return std::nullopt;
  const Eigen::Matrix<double, n, 1> factors = gram.inverse() * missing;
  return p + normals.transpose() * factors;
}

}  // namespace

std::optional<Eigen::Vector3d> closest_point_in(std::span<const HalfSpace> half_spaces, const Eigen::Vector3d& p) {
  // The closest point lies on at most three of the planes: try all sets of them.
  Best best(half_spaces, p);
  best.offer(p);
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    const HalfSpace& first = half_spaces[i];
    best.offer(p + (first.bound - first.normal.dot(p)) * first.normal);
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto x = closest_on_planes<2>({&first, &half_spaces[j]}, p)) best.offer(*x);
      for (std::size_t k = 0; k < j; ++k) {
        if (const auto x = closest_on_planes<3>({&first, &half_spaces[j], &half_spaces[k]}, p)) best.offer(*x);
      }
    }
  }
  return best.point();
}

}  // namespace shapegauge
