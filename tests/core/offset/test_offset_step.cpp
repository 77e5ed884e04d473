// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <optional>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/offset_step-inl.h"

/// The step of the iteration to q, for one sample: the library instantiates the same functions for one sample per lane.
namespace shapegauge {
namespace {

using HWY_NAMESPACE::ActiveContact;
using HWY_NAMESPACE::Feature;
using HWY_NAMESPACE::HalfSpace;
using HWY_NAMESPACE::max_contacts;
using HWY_NAMESPACE::Projection;
using Vector = HWY_NAMESPACE::Vector3<float>;

constexpr std::size_t half_spaces_per_problem = max_contacts;

/// Half-spaces normal . x >= height, onto whose intersection the origin is projected. A normal of 0 stands for none.
struct ProjectionProblem {
  std::array<Eigen::Vector3d, half_spaces_per_problem> normals;
  std::array<double, half_spaces_per_problem> heights;
};

Vector to_floats(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Eigen::Vector3d to_doubles(const Vector& v) { return Eigen::Vector3f(v.x, v.y, v.z).cast<double>(); }

Projection<float> project(const ProjectionProblem& problem) {
  std::array<HalfSpace<float>, max_contacts> half_spaces;
  for (std::size_t i = 0; i < max_contacts; ++i) {
    const float height =
        problem.normals[i].isZero() ? HWY_NAMESPACE::unbounded_height : static_cast<float>(problem.heights[i]);
    half_spaces[i] = {to_floats(problem.normals[i]), height};
  }
  return HWY_NAMESPACE::Projector<float>(half_spaces).find();
}

ProjectionProblem no_half_spaces() {
  ProjectionProblem problem;
  problem.normals.fill(Eigen::Vector3d::Zero());
  problem.heights.fill(0);
  return problem;
}

double largest_violation(const ProjectionProblem& problem, const Eigen::Vector3d& x) {
  double largest = -1e30;
  for (std::size_t i = 0; i < half_spaces_per_problem; ++i) {
    if (problem.normals[i].isZero()) continue;
    largest = std::max(largest, problem.heights[i] - problem.normals[i].dot(x));
  }
  return largest;
}

/// The shortest of the points that lie in all half-spaces, lowered, and are nearest to the origin on one, two or three
/// of their planes. Empty if there is none.
std::optional<Eigen::Vector3d> projection_of(ProjectionProblem problem, double lowered = 0) {
  for (double& height : problem.heights) height -= lowered;
  std::optional<Eigen::Vector3d> best;
  for (unsigned chosen = 0; chosen < 1U << half_spaces_per_problem; ++chosen) {
    if (std::popcount(chosen) > 3) continue;
    Eigen::Matrix3d planes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d heights = Eigen::Vector3d::Zero();
    Eigen::Index count = 0;
    for (std::size_t i = 0; i < half_spaces_per_problem; ++i) {
      if ((chosen >> i & 1U) == 0) continue;
      planes.row(count) = problem.normals[i];
      heights[count++] = problem.heights[i];
    }
    // The point of one or two planes that is nearest to the origin is also on the perpendicular planes through the
    // origin.
    if (count == 1) planes.row(1) = planes.row(0).unitOrthogonal();
    if (count < 3) planes.row(2) = planes.row(0).cross(planes.row(1));
    const Eigen::Vector3d x = planes.inverse() * heights;
    if (!x.allFinite() || largest_violation(problem, x) > 1e-9 || (best && x.norm() >= best->norm())) continue;
    best = x;
  }
  return best;
}

/// Least determinant of the Gram matrices of two or three normals; 1 for fewer.
double min_determinant_of(const ProjectionProblem& problem) {
  double least = 1;
  const auto& n = problem.normals;
  for (std::size_t i = 0; i < half_spaces_per_problem; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (n[i].isZero() || n[j].isZero()) continue;
      least = std::min(least, n[i].cross(n[j]).squaredNorm());
      for (std::size_t k = 0; k < j; ++k) {
        if (!n[k].isZero()) least = std::min(least, std::pow(n[i].cross(n[j]).dot(n[k]), 2));
      }
    }
  }
  return least;
}

/// Bound of the rounding errors in single precision: of a few operations on heights up to 5, divided by determinants of
/// at least 1e-5.
double rounding_of(const ProjectionProblem& problem) {
  constexpr double epsilon = 1.2e-7;
  return 4 * 5 * epsilon / std::max(min_determinant_of(problem), 1e-5);
}

Eigen::Vector3d unit_vector(RandomNumbers& random) {
  for (;;) {
    const Eigen::Vector3d v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

/// Tangent planes of a group of balls: normals mostly to one side. Their half-spaces have common points.
std::vector<ProjectionProblem> solvable_problems(int count) {
  RandomNumbers random(1);
  std::vector<ProjectionProblem> problems;
  for (int i = 0; i < count; ++i) {
    ProjectionProblem problem = no_half_spaces();
    const Eigen::Vector3d inside = random.uniform(0.5, 5) * unit_vector(random);
    const double spread = random.uniform(0.1, 2);
    const std::size_t half_spaces = random.below(half_spaces_per_problem + 1);
    for (std::size_t k = 0; k < half_spaces; ++k) {
      problem.normals[k] = (inside.normalized() + spread * unit_vector(random)).normalized();
      problem.heights[k] = problem.normals[k].dot(inside) - random.uniform(0.05, 1);
    }
    problems.push_back(problem);
  }
  return problems;
}

constexpr double slack_of_planes = 1e-4;  // the tolerance of the projection

TEST(HalfSpaceProjection, IsTheNearestPointOfTheIntersection) {
  std::array<int, 4> counts{};
  int regular = 0;
  for (const ProjectionProblem& problem : solvable_problems(3000)) {
    const Projection<float> found = project(problem);
    if (min_determinant_of(problem) > 1e-3) {
      ASSERT_TRUE(found.is_found);
      ++regular;
    }
    if (!found.is_found) continue;
    const std::optional<Eigen::Vector3d> exact = projection_of(problem);
    ASSERT_TRUE(exact);
    const Eigen::Vector3d x = to_doubles(found.x);
    EXPECT_LT(largest_violation(problem, x), slack_of_planes + rounding_of(problem));
    EXPECT_LT(x.norm(), exact->norm() + rounding_of(problem));
    ASSERT_TRUE(found.count >= 0 && found.count <= 3);
    ++counts[static_cast<std::size_t>(found.count)];
  }
  EXPECT_GT(regular, 1000);
  for (const int count : counts) EXPECT_GT(count, 100) << "of each number of active half-spaces";
}

TEST(HalfSpaceProjection, IsANonNegativeCombinationOfActiveNormals) {
  for (const ProjectionProblem& problem : solvable_problems(1000)) {
    const Projection<float> found = project(problem);
    if (!found.is_found || found.count > 2) continue;
    const Eigen::Vector3d x = to_doubles(found.x);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k) {
      EXPECT_GE(found.pushes[k], 0);
      const auto contact = static_cast<std::size_t>(found.contacts[k]);
      ASSERT_LT(contact, half_spaces_per_problem);
      sum += static_cast<double>(found.pushes[k]) * problem.normals[contact];
      // Its plane contains the projection.
      EXPECT_NEAR(problem.normals[contact].dot(x), problem.heights[contact], rounding_of(problem));
    }
    EXPECT_LT((sum - x).norm(), rounding_of(problem));
  }
}

TEST(HalfSpaceProjection, IsNotFoundForEmptyIntersections) {
  RandomNumbers random(2);
  int empty = 0;
  for (int i = 0; i < 4000; ++i) {
    ProjectionProblem problem = no_half_spaces();
    for (std::size_t k = 0; k < 3 + random.below(3); ++k) {
      problem.normals[k] = unit_vector(random);
      problem.heights[k] = random.uniform(-0.5, 1.5);
    }
    if (projection_of(problem, 5 * slack_of_planes)) continue;
    EXPECT_FALSE(project(problem).is_found);
    ++empty;
  }
  EXPECT_GT(empty, 100);
}

TEST(HalfSpaceProjection, MatchesCasesComputedByHand) {
  std::vector<ProjectionProblem> problems(5, no_half_spaces());
  problems[1].normals[2] = {0, 0.6, 0.8};
  problems[1].heights[2] = -1;  // contains the origin
  problems[2] = problems[1];
  problems[2].heights[2] = 2;
  problems[3].normals = {Eigen::Vector3d(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  problems[3].heights = {1, 2, 3, 0, 0};
  problems[4].normals = {Eigen::Vector3d(1, 0, 0), {-1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  problems[4].heights = {1, 1, 0, 0, 0};
  const std::vector<Eigen::Vector3d> expected{{0, 0, 0}, {0, 0, 0}, {0, 1.2, 1.6}, {1, 2, 3}};
  const std::vector<int> counts{0, 0, 1, 3};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Projection<float> found = project(problems[i]);
    EXPECT_TRUE(found.is_found) << i;
    EXPECT_LT((to_doubles(found.x) - expected[i]).norm(), 1e-5) << i;
    EXPECT_EQ(found.count, counts[i]) << i;
  }
  EXPECT_FALSE(project(problems[4]).is_found);
}

TEST(TriangleFeature, IsTheFaceEdgeOrCornerThatContainsThePoint) {
  // Corner a at the origin, b and c on the axes; then the vectors that give the coordinates of a point.
  const std::array<float, 16> record{0, 0, 0, 2, 0, 0, 0, 3, 0, 0.5F, 0, 0, 0, 1 / 3.0F, 0, 0};
  const auto feature = [&](double x, double y) {
    return HWY_NAMESPACE::feature_at<float>(record.data(), to_floats({x, y, 0}));
  };
  EXPECT_TRUE(feature(0.5, 0.5).is_face);
  const std::array<Eigen::Vector2d, 3> corners{Eigen::Vector2d(0, 0), {2, 0}, {0, 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Feature<float> corner = feature(corners[i].x(), corners[i].y());
    EXPECT_FALSE(corner.is_face);
    EXPECT_EQ(to_doubles(corner.edge).norm(), 0);
    const Eigen::Vector2d along = corners[(i + 1) % 3] - corners[i];
    const Eigen::Vector2d middle = corners[i] + along / 2;
    const Feature<float> edge = feature(middle.x(), middle.y());
    EXPECT_FALSE(edge.is_face);
    const Eigen::Vector3d expected(along.x(), along.y(), 0);
    EXPECT_NEAR(std::abs(to_doubles(edge.edge).dot(expected.normalized())), 1, 1e-6);
  }
}

/// Balls of radius r about features that contain the given centres: q is on the ray from the origin through p, since
/// the centres are symmetric. Returns the angle between the ray and the corrected step from a start at another angle.
double angle_after_step(const std::vector<Eigen::Vector3d>& centres, const Eigen::Vector3d& edge, double r) {
  const double radius = std::sqrt(r * r - centres[0].squaredNorm());
  const Eigen::Vector3d direction(std::cos(0.2), std::sin(0.2), 0);
  const Eigen::Vector3d p = 0.6 * r * direction;
  const Eigen::Vector3d start = radius * Eigen::Vector3d::UnitX() - p;  // relative to p
  ProjectionProblem problem = no_half_spaces();
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Eigen::Vector3d from_centre = start - (centres[i] - p);
    const HalfSpace<float> free = HWY_NAMESPACE::tangent_half_space(to_floats(start), to_floats(from_centre),
                                                                    static_cast<float>(r), static_cast<float>(r));
    problem.normals[i] = to_doubles(free.normal);
    problem.heights[i] = static_cast<double>(free.height);
  }
  const Projection<float> to = project(problem);
  std::array<ActiveContact<float>, 2> active{};
  for (std::size_t k = 0; k < centres.size(); ++k) {
    active[k] = {to_floats(problem.normals[static_cast<std::size_t>(to.contacts[k])]), {false, to_floats(edge)}};
  }
  const Vector step = to_floats(to_doubles(to.x) - start);
  const Vector more = HWY_NAMESPACE::curvature_correction(to, active, step, static_cast<float>(r));
  const Eigen::Vector3d x = p + start + to_doubles(step) + to_doubles(more);
  return std::atan2(x.cross(direction).norm(), x.dot(direction));
}

TEST(CurvatureCorrection, ReachesTheNearestOffsetPointInOneStepAroundCornersAndEdges) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  EXPECT_LT(angle_after_step({none}, none, 2), 1e-5) << "corner";
  EXPECT_LT(angle_after_step({none}, Eigen::Vector3d::UnitZ(), 2), 1e-5) << "edge";
  EXPECT_LT(angle_after_step({{0, 0, 0.7}, {0, 0, -0.7}}, none, 2), 1e-5) << "two corners";
  EXPECT_GT(angle_after_step({none}, Eigen::Vector3d::UnitY(), 2), 0.05) << "along an edge there is no curvature";
}

}  // namespace
}  // namespace shapegauge
