// Compiled for each instruction set supported by Highway, as the sources of the library that include the header.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/offset/test_half_space_projection.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#ifndef SHAPEGAUGE_TESTS_HALF_SPACE_PROJECTION
#define SHAPEGAUGE_TESTS_HALF_SPACE_PROJECTION

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace shapegauge {

constexpr std::size_t half_spaces_per_problem = 5;

/// Half-spaces normal . x >= height, onto whose intersection the origin is projected. A normal of 0 stands for none.
struct ProjectionProblem {
  std::array<Eigen::Vector3d, half_spaces_per_problem> normals;
  std::array<double, half_spaces_per_problem> heights;
};

struct ProjectionAnswer {
  bool is_found = false;
  Eigen::Vector3d x;
  int count = 0;
  std::array<double, 2> multipliers;
  std::array<std::size_t, 2> contacts;
};

}  // namespace shapegauge

#endif

#include "shapegauge/core/offset/half_space_projection-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

void project_lanes(std::span<const ProjectionProblem> problems, std::span<ProjectionAnswer> answers) {
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t first = 0; first < problems.size(); first += lanes) {
    std::array<Contact, max_contacts> contacts{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const ProjectionProblem& problem = problems[std::min(first + lane, problems.size() - 1)];
      for (std::size_t i = 0; i < max_contacts; ++i) {
        contacts[i].normal.set(lane, problem.normals[i].cast<float>());
        contacts[i].height[lane] = problem.normals[i].isZero() ? no_height : static_cast<float>(problem.heights[i]);
      }
    }
    const Projections found = Projector(contacts).find();
    VectorLanes x;
    IntegerLanes count;
    std::array<IntegerLanes, 2> active;
    std::array<RealLanes, 2> multipliers;
    store(found.x, x);
    store(found.count, count);
    for (std::size_t k = 0; k < 2; ++k) {
      store(found.contacts[k], active[k]);
      store(found.multipliers[k], multipliers[k]);
    }
    const LaneBits is_found = bits_of(found.is_found);
    for (std::size_t lane = 0; lane < lanes && first + lane < problems.size(); ++lane) {
      ProjectionAnswer& answer = answers[first + lane];
      answer = {(is_found >> lane & 1U) != 0, x.at(lane), count[lane], {}, {}};
      for (std::size_t k = 0; k < 2; ++k) {
        answer.multipliers[k] = static_cast<double>(multipliers[k][lane]);
        answer.contacts[k] = static_cast<std::size_t>(active[k][lane]);
      }
    }
  }
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

HWY_EXPORT(project_lanes);

namespace {

/// Solves the problems with every instruction set of this processor.
template <typename Check>
void for_each_instruction_set(std::span<const ProjectionProblem> problems, const Check& check) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    std::vector<ProjectionAnswer> answers(problems.size());
    HWY_DYNAMIC_DISPATCH(project_lanes)(problems, answers);
    for (std::size_t i = 0; i < problems.size(); ++i) {
      SCOPED_TRACE(i);
      check(problems[i], answers[i]);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
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
    Eigen::Matrix<double, half_spaces_per_problem, 3> planes = decltype(planes)::Zero();
    Eigen::Matrix<double, half_spaces_per_problem, 1> heights = decltype(heights)::Zero();
    for (std::size_t i = 0; i < half_spaces_per_problem; ++i) {
      if ((chosen >> i & 1U) == 0) continue;
      planes.row(static_cast<Eigen::Index>(i)) = problem.normals[i];
      heights[static_cast<Eigen::Index>(i)] = problem.heights[i];
    }
    const Eigen::Vector3d x = planes.completeOrthogonalDecomposition().solve(heights);
    if (largest_violation(problem, x) > 1e-9 || (best && x.norm() >= best->norm())) continue;
    best = x;
  }
  return best;
}

/// Least determinant of the Gram matrices of two or three normals; 1 for fewer.
double least_determinant_of(const ProjectionProblem& problem) {
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
  return 4 * 5 * epsilon / std::max(least_determinant_of(problem), 1e-5);
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
  for_each_instruction_set(solvable_problems(3000),
                           [&](const ProjectionProblem& problem, const ProjectionAnswer& found) {
                             if (least_determinant_of(problem) > 1e-3) {
                               ASSERT_TRUE(found.is_found);
                               ++regular;
                             }
                             if (!found.is_found) return;
                             const std::optional<Eigen::Vector3d> exact = projection_of(problem);
                             ASSERT_TRUE(exact);
                             EXPECT_LT(largest_violation(problem, found.x), slack_of_planes + rounding_of(problem));
                             EXPECT_LT(found.x.norm(), exact->norm() + rounding_of(problem));
                             ASSERT_TRUE(found.count >= 0 && found.count <= 3);
                             ++counts[static_cast<std::size_t>(found.count)];
                           });
  EXPECT_GT(regular, 1000);
  for (const int count : counts) EXPECT_GT(count, 100) << "of each number of active half-spaces";
}

TEST(HalfSpaceProjection, IsTheSumOfNormalsByMultipliers) {
  for_each_instruction_set(
      solvable_problems(1000), [](const ProjectionProblem& problem, const ProjectionAnswer& found) {
        if (!found.is_found || found.count > 2) return;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k) {
          EXPECT_GE(found.multipliers[k], 0);
          ASSERT_LT(found.contacts[k], half_spaces_per_problem);
          const std::size_t contact = found.contacts[k];
          sum += found.multipliers[k] * problem.normals[contact];
          // Its plane contains the projection.
          EXPECT_NEAR(problem.normals[contact].dot(found.x), problem.heights[contact], rounding_of(problem));
        }
        EXPECT_LT((sum - found.x).norm(), rounding_of(problem));
      });
}

TEST(HalfSpaceProjection, OfEmptyIntersectionsIsNotFound) {
  RandomNumbers random(2);
  std::vector<ProjectionProblem> problems;
  for (int i = 0; i < 4000; ++i) {
    ProjectionProblem problem = no_half_spaces();
    for (std::size_t k = 0; k < 3 + random.below(3); ++k) {
      problem.normals[k] = unit_vector(random);
      problem.heights[k] = random.uniform(-0.5, 1.5);
    }
    problems.push_back(problem);
  }
  int empty = 0;
  for_each_instruction_set(problems, [&](const ProjectionProblem& problem, const ProjectionAnswer& found) {
    if (projection_of(problem, 5 * slack_of_planes)) return;
    EXPECT_FALSE(found.is_found);
    ++empty;
  });
  EXPECT_GT(empty, 100);
}

TEST(HalfSpaceProjection, ByHand) {
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
  std::size_t i = 0;
  for_each_instruction_set(problems, [&](const ProjectionProblem& /*problem*/, const ProjectionAnswer& found) {
    const std::size_t number = i++ % problems.size();
    EXPECT_EQ(found.is_found, number < 4);
    if (number >= 4) return;
    EXPECT_LT((found.x - expected[number]).norm(), 1e-5);
    EXPECT_EQ(found.count, counts[number]);
  });
}

}  // namespace
}  // namespace shapegauge

#endif  // HWY_ONCE
