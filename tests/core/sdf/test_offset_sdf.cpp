// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <limits>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

OffsetSdfResult at_faces(const Shape& shape, double offset) {
  return offset_sdf(shape, sample_shape(shape, SampleSite::faces), {.offset = offset});
}

/// Offsets of the paper, and one above and one below them.
const std::vector<double> offsets = {0.001, 0.003, 0.01, 0.03, 0.05, 0.12};

TEST(OffsetSdf, OfASphereIsItsDiameter) {
  const Shape sphere = test::sphere(1, 4);
  // The polyhedron's faces lie below the sphere by this much at most.
  const double sagitta = 1 - sample_shape(sphere, SampleSite::faces).points.rowwise().norm().minCoeff();
  for (const double offset : offsets) {
    const OffsetSdfResult result = at_faces(sphere, offset);
    const double tolerance = 2 * sagitta + 1e-3 * offset * bounding_box_diagonal(sphere);
    EXPECT_LE(result.values.maxCoeff(), 2 + tolerance) << offset;
    EXPECT_GE(result.values.minCoeff(), 2 - tolerance) << offset;
    EXPECT_EQ(result.outcomes.undecided, 0U);
  }
}

TEST(OffsetSdf, OfACapsuleOnItsSideIsItsDiameter) {
  const Shape capsule = test::capsule(0.5, 4, 96, 24);
  const Samples samples = sample_shape(capsule, SampleSite::faces);
  for (const double offset : offsets) {
    const OffsetSdfResult result = offset_sdf(capsule, samples, {.offset = offset});
    for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
      if (std::abs(samples.points(i, 2)) < 1.8) {
        EXPECT_NEAR(result.values[i], 1, 5e-3) << offset << " " << i;
      }
    }
  }
}

TEST(OffsetSdf, OfASlabIsItsThicknessAwayFromTheRim) {
  const Shape slab = test::box({4, 4, 0.3}, 12);
  const Samples samples = sample_shape(slab, SampleSite::faces);
  for (const double offset : offsets) {
    const OffsetSdfResult result = offset_sdf(slab, samples, {.offset = offset});
    const double r = offset * bounding_box_diagonal(slab);
    for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
      const bool inner = samples.points.row(i).head<2>().cwiseAbs().maxCoeff() < 1.9;
      if (inner) {
        EXPECT_NEAR(result.values[i], 0.3, 1e-3 * r) << offset << " " << i;
      }
    }
  }
}

TEST(OffsetSdf, OfATorusIsTheDiameterOfTheTubeOnTheOuterEquator) {
  const Shape torus = test::torus(2, 0.4, 120, 60);
  const Samples samples = sample_shape(torus, SampleSite::faces);
  for (const double offset : {0.001, 0.01, 0.03, 0.05, 0.2}) {  // the hole of radius 1.6 stays open: r <= 1.13
    const OffsetSdfResult result = offset_sdf(torus, samples, {.offset = offset});
    for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
      const Eigen::Vector3d p = samples.points.row(i);
      if (p.head<2>().norm() > 2.395) {
        EXPECT_NEAR(result.values[i], 0.8, 0.01) << offset;
      }
    }
  }
}

TEST(OffsetSdf, OfATorusWithAClosedHoleReachesAcrossTheHole) {
  // The hole's radius is 0.3 and r is 0.85: the offset solid has no hole, and a ray from the outer equator goes all the
  // way through the middle.
  const Shape torus = test::torus(1, 0.7, 120, 60);
  const double offset = 0.85 / bounding_box_diagonal(torus);
  const Samples samples = sample_shape(torus, SampleSite::faces);
  const OffsetSdfResult result = offset_sdf(torus, samples, {.offset = offset});
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    if (samples.points.row(i).head<2>().norm() > 1.697) {
      EXPECT_NEAR(result.values[i], 3.4, 0.02);
    }
  }
}

TEST(OffsetSdf, OfTwoOverlappingSpheresSpansBothSpheresAlongTheirAxis) {
  Shape second = test::sphere(1, 4);
  second.vertices.col(0).array() += 1.2;
  const Shape both = test::joined({test::sphere(1, 4), second});
  const OffsetSdfResult result = at_faces(both, 0.02);
  const Samples samples = sample_shape(both, SampleSite::faces);
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    const Eigen::Vector3d p = samples.points.row(i);
    if (p[0] < -0.995) {  // the poles
      EXPECT_NEAR(result.values[i], 3.2, 0.03);
    }
    if (std::abs(p[0] + 0.3) < 0.05) {  // away from the seam
      EXPECT_NEAR(result.values[i], 2, 0.02) << p.transpose();
    }
  }
  EXPECT_GE(result.values.minCoeff(), 0);
}

TEST(OffsetSdf, IgnoresAVoidInsideTheShape) {
  Shape inner = test::flipped(test::sphere(0.5, 3));
  const Shape hollow = test::joined({test::sphere(1, 3), inner});
  const Samples samples = sample_shape(hollow, SampleSite::faces);
  const OffsetSdfResult result = offset_sdf(hollow, samples, {.offset = 0.03});
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    // From the outer surface straight through; from the inner one, q is on the outer offset surface all the same.
    EXPECT_NEAR(result.values[i], 2, 0.04);
    EXPECT_GT(result.normals.row(i).dot(samples.points.row(i).normalized()), 0.95);
  }
  EXPECT_GT(result.outcomes.searched, 0U);
}

/// A closed box with a cavity that a square shaft of the given width joins to the outside: an outer box whose top has a
/// hole, the shaft's four walls, and an inner box whose top has the same hole.
Shape box_with_cavity(double outer, double inner, double shaft) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;
  const auto quad = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        const Eigen::Vector3d& d) {
    const int first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c, d});
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
  };
  const auto corner = [](double half, int i, double z) {
    return Eigen::Vector3d(i == 0 || i == 3 ? -half : half, i < 2 ? -half : half, z);
  };
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    for (const double half : {outer, inner}) {
      quad(corner(half, i, -half), corner(half, j, -half), corner(half, j, half), corner(half, i, half));
      quad(corner(half, i, half), corner(half, j, half), corner(shaft, j, half), corner(shaft, i, half));
    }
    quad(corner(shaft, i, inner), corner(shaft, j, inner), corner(shaft, j, outer), corner(shaft, i, outer));
  }
  for (const double half : {outer, inner}) {
    quad(corner(half, 0, -half), corner(half, 1, -half), corner(half, 2, -half), corner(half, 3, -half));
  }
  return test::mesh_of(vertices, triangles);
}

/// The offset SDF in the middle of the cavity's floor.
OffsetSdfResult on_the_floor(const Shape& box, double offset) {
  Samples samples;
  samples.points = Points{{0.1, 0.05, -0.7}};
  samples.normals = Points{{0, 0, 1}};
  samples.weights = Eigen::VectorXd::Ones(1);
  return offset_sdf(box, samples, {.offset = offset});
}

TEST(OffsetSdf, ClosesACavityWhoseShaftIsNarrowerThanTwiceTheOffset) {
  const double half_shaft = 0.12;
  const Shape box = box_with_cavity(1, 0.7, half_shaft);
  const double diagonal = bounding_box_diagonal(box);
  const OffsetSdfResult open = on_the_floor(box, 0.5 * half_shaft / diagonal);
  EXPECT_EQ(open.outcomes.direct, 1U);
  EXPECT_NEAR(open.values[0], 0.3, 1e-3);  // through the floor
  EXPECT_GT(open.normals(0, 2), 0.999);
  const OffsetSdfResult shut = on_the_floor(box, 2 * half_shaft / diagonal);
  EXPECT_EQ(shut.outcomes.searched, 1U);
  EXPECT_NEAR(shut.values[0], 2, 2e-2);  // from below the floor to above the lid
  EXPECT_LT(shut.normals(0, 2), -0.999);
}

TEST(OffsetSdf, FindsAShaftNarrowerThanTheGridCubes) {
  // The octree's planes of symmetry are the shaft's: with cubes of 3r/4, no centre of one is in its free part, 0.6 r
  // wide, until they are divided.
  const double offset = 0.01;
  const double r = offset * bounding_box_diagonal(box_with_cavity(1, 0.7, 0.1));
  const OffsetSdfResult open = on_the_floor(box_with_cavity(1, 0.7, 1.3 * r), offset);
  EXPECT_EQ(open.outcomes.direct, 1U);
  EXPECT_NEAR(open.values[0], 0.3, 1e-3);
  const OffsetSdfResult shut = on_the_floor(box_with_cavity(1, 0.7, 0.95 * r), offset);
  EXPECT_EQ(shut.outcomes.searched, 1U);
  EXPECT_NEAR(shut.values[0], 2, 2e-3);
}

TEST(OffsetSdf, ComputesOutwardNormalsOfASphere) {
  const Shape sphere = test::sphere(1, 4);
  const Samples samples = sample_shape(sphere, SampleSite::vertices);
  const OffsetSdfResult result = offset_sdf(sphere, samples, {.offset = 0.05});
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    EXPECT_GT(result.normals.row(i).dot(samples.points.row(i).normalized()), std::cos(0.02));
  }
}

/// A sphere with random bumps and dents: closed, with concavities of many widths.
Shape bumpy_sphere(unsigned seed) {
  Shape shape = test::sphere(1, 2);
  std::srand(seed);
  const Eigen::Matrix<double, 12, 3> centres = Eigen::Matrix<double, 12, 3>::Random().rowwise().normalized();
  const Eigen::Matrix<double, 12, 1> heights = 0.5 * Eigen::Matrix<double, 12, 1>::Random();
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    const Eigen::Vector3d x = shape.vertices.row(i);
    double scale = 1;
    for (int k = 0; k < 12; ++k) {
      scale += heights[k] * std::exp(-12 * (x - centres.row(k).transpose()).squaredNorm());
    }
    shape.vertices.row(i) *= std::max(scale, 0.2);
  }
  return shape;
}

/// Two samples may have different closest points at nearly the same distance, between which rounding chooses: values
/// are compared by the share of samples that agree.
double share_that_differs(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double tolerance) {
  return static_cast<double>(((a - b).cwiseAbs().array() > tolerance).count()) / static_cast<double>(a.size());
}

RC_GTEST_PROP(OffsetSdf, IsNeverNegative, ()) {
  const Shape shape = bumpy_sphere(*rc::gen::arbitrary<unsigned>());
  const double offset = *rc::gen::inRange(5, 200) / 1000.0;
  const OffsetSdfResult result = at_faces(shape, offset);
  RC_ASSERT(result.values.allFinite());
  RC_ASSERT(result.values.minCoeff() >= 0);
  RC_ASSERT(result.outcomes.total == static_cast<std::size_t>(shape.triangles.rows()));
  RC_ASSERT(result.outcomes.direct + result.outcomes.searched + result.outcomes.undecided == result.outcomes.total);
}

RC_GTEST_PROP(OffsetSdf, IsInvariantUnderRigidMotionAndProportionalToScale, ()) {
  const Shape shape = bumpy_sphere(*rc::gen::arbitrary<unsigned>());
  const double offset = *rc::gen::inRange(15, 150) / 1000.0;
  const double scale = std::pow(10, *rc::gen::inRange(-30, 31));
  const Shape moved = test::transformed(shape, scale, test::rotation(*rc::gen::arbitrary<unsigned>()),
                                        scale * Eigen::Vector3d(3, -2, 5));
  const double r = offset * bounding_box_diagonal(shape);
  // The box turns too: r is the same length only when it is given as a fraction of the turned box.
  const Eigen::VectorXd before = at_faces(shape, offset).values;
  const Eigen::VectorXd after = at_faces(moved, r * scale / bounding_box_diagonal(moved)).values / scale;
  RC_ASSERT(share_that_differs(before, after, 0.05 * r) < 0.05);
}

RC_GTEST_PROP(OffsetSdf, DoesNotDependOnTheOrderOrOrientationOfFaces, ()) {
  const Shape shape = bumpy_sphere(*rc::gen::arbitrary<unsigned>());
  const double offset = *rc::gen::inRange(15, 150) / 1000.0;
  const double r = offset * bounding_box_diagonal(shape);
  const Eigen::VectorXd before = at_faces(shape, offset).values;
  RC_ASSERT(share_that_differs(before, at_faces(test::flipped(shape), offset).values, 0.05 * r) < 0.02);
  const test::Permuted permuted = test::permuted(shape, *rc::gen::arbitrary<unsigned>());
  const Eigen::VectorXd shuffled = at_faces(permuted.shape, offset).values;
  Eigen::VectorXd restored(shuffled.size());
  for (std::size_t f = 0; f < permuted.triangles.size(); ++f) {
    restored[permuted.triangles[f]] = shuffled[static_cast<Eigen::Index>(f)];
  }
  RC_ASSERT(share_that_differs(before, restored, 0.05 * r) < 0.02);
}

TEST(OffsetSdf, TendsToTheRayLengthAsTheOffsetVanishes) {
  const Shape slab = test::box({3, 2, 1}, 6);
  const OffsetSdfResult result = at_faces(slab, 1e-3);
  const Samples samples = sample_shape(slab, SampleSite::faces);
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    Eigen::Index axis = 0;
    samples.normals.row(i).cwiseAbs().maxCoeff(&axis);
    EXPECT_NEAR(result.values[i], 3.0 - static_cast<double>(axis), 1e-5);
  }
}

TEST(OffsetSdf, IsIdenticalForEverySimdVectorWidth) {
  for (const Shape& shape : {bumpy_sphere(3), test::torus(1, 0.4, 60, 40)}) {
    for (const double offset : {0.01, 0.05}) {
      const Eigen::VectorXd expected = at_faces(shape, offset).values;
      for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        // Without fused multiplication, rounding differs.
        if (target > HWY_AVX2) continue;
        hwy::SetSupportedTargetsForTest(target);
        EXPECT_EQ(at_faces(shape, offset).values, expected) << hwy::TargetName(target) << ' ' << offset;
      }
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

TEST(OffsetSdf, OfASphereCloudIsItsDiameter) {
  Shape cloud = test::random_points(test::sphere(1, 5), 4000, 1);
  for (const double scale : {1e-30, 1.0, 1e30}) {
    Shape scaled = cloud;
    scaled.vertices *= scale;
    for (const bool with_normals : {false, true}) {
      scaled.normals = with_normals ? Points(cloud.vertices.rowwise().normalized()) : Points();
      const OffsetSdfResult result = at_faces(scaled, 0.05);
      EXPECT_EQ(result.outcomes.undecided, 0U);
      EXPECT_GE(result.values.minCoeff(), 0);
      // r is 0.17, and the largest hole among the points has a radius h of about 0.1. The offset surface dents there by
      // r - sqrt(r^2 - h^2) = 0.03, and the middle of what p's ball exposes may be off the normal by about half of
      // the angle whose sine is h/r: 2 cos 18 degrees, less a dent or two, is 1.84.
      EXPECT_NEAR(result.values.mean() / scale, 2, 0.03);
      EXPECT_GT(result.values.minCoeff() / scale, 1.8);
      EXPECT_LT(result.values.maxCoeff() / scale, 2.05);
    }
  }
}

TEST(OffsetSdf, OfPointsInAPlaneIsZeroAwayFromTheRim) {
  const Shape plane = test::random_points(test::box({1, 1, 0}, 1), 4000, 1);
  const OffsetSdfResult result = at_faces(plane, 0.05);
  const double r = 0.05 * bounding_box_diagonal(plane);
  EXPECT_GE(result.values.minCoeff(), 0);
  double sum = 0;
  int inner = 0;
  for (Eigen::Index i = 0; i < plane.vertices.rows(); ++i) {
    if (plane.vertices.row(i).cwiseAbs().maxCoeff() > 0.5 - 2 * r) continue;
    sum += result.values[i];
    ++inner;
  }
  EXPECT_LT(sum / inner, 0.1 * r);
}

TEST(OffsetSdf, OfFarPointsNextToADenseClusterIsNearZero) {
  Shape cloud = test::random_points(test::sphere(1, 3), 1000, 1);
  cloud.vertices.row(0) << 1000, 0, 0;
  cloud.vertices.row(1) << -1000, 500, 0;
  const OffsetSdfResult result = at_faces(cloud, 0.01);
  const double r = 0.01 * bounding_box_diagonal(cloud);  // 20 times the cluster's radius
  EXPECT_EQ(result.outcomes.undecided, 0U);
  EXPECT_LT(result.values.head<2>().maxCoeff(), 2e-3 * r);  // a point alone in its ball: 1e-3 r at either end
  EXPECT_GE(result.values.minCoeff(), 0);
  EXPECT_LT(result.values.maxCoeff(), 2 + 2e-3 * r);
}

TEST(OffsetSdf, OfTwoPointsIsNearZeroAndASinglePointIsRejected) {
  const Shape two{(Points(2, 3) << 0, 0, 0, 1, 0, 0).finished(), {}, {}};
  EXPECT_LT(at_faces(two, 0.05).values.maxCoeff(), 2e-3 * 0.05);
  EXPECT_THROW(at_faces({Points::Ones(1, 3), {}, {}}, 0.05), InputError);
  EXPECT_THROW(at_faces({Points::Ones(40, 3), {}, {}}, 0.05), InputError);
}

TEST(OffsetSdf, RejectsInvalidOffsetsAndShapesWithoutExtent) {
  const Shape sphere = test::sphere(1, 1);
  for (const double offset : {0.0, -0.1, 0.9e-6, 1.001, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(at_faces(sphere, offset), InputError);
  }
  EXPECT_THROW(at_faces(Shape{}, 0.05), InputError);
  Shape point = sphere;
  point.vertices.setOnes();
  EXPECT_THROW(at_faces(point, 0.05), InputError);
}

}  // namespace
}  // namespace shapegauge
