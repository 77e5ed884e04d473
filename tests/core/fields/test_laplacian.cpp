// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/laplacian.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using test::sphere;

TEST(Laplacian, AnnihilatesConstantsAndHasTheSurfaceAreaAsMass) {
  const Shape shape = test::torus(2, 0.5, 12, 30);
  const Laplacian laplacian = cotangent_laplacian(shape);
  EXPECT_LT((laplacian.stiffness * Eigen::VectorXd::Ones(laplacian.mass.size())).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(laplacian.mass.sum(), surface_area(shape), 1e-9);
}

TEST(Laplacian, EnergyOfALinearFunctionIsTheAreaTimesItsSquaredSlope) {
  const Shape shape = test::rectangle(2, 1, 10, 5);
  const Laplacian laplacian = cotangent_laplacian(shape);
  Eigen::VectorXd values(laplacian.mass.size());
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    values[laplacian.node_of[static_cast<std::size_t>(v)]] = 3 * shape.vertices(v, 0) + 4 * shape.vertices(v, 1);
  }
  EXPECT_NEAR(values.dot(laplacian.stiffness * values), 2 * 25, 1e-9);
}

TEST(Laplacian, EigenvaluesOfTheUnitSphereMatchSphericalHarmonics) {
  const Spectrum spectrum = laplacian_spectrum(sphere(1, 4), 25);
  Eigen::Index k = 0;
  for (int l = 0; l < 5; ++l) {
    for (int m = -l; m <= l; ++m, ++k) {
      // Linear elements have a relative error of about lambda h^2 / 12; edges have length 0.07.
      EXPECT_NEAR(spectrum.eigenvalues[k], l * (l + 1), 0.02 * l * (l + 1) + 1e-8) << l << " " << m;
    }
  }
}

TEST(Laplacian, SpectrumRepeatsMultipleEigenvaluesForAnyRequestedCount) {
  // 17 to 24 eigenvalues end among the nine copies of 20, which the mesh divides into four and five.
  for (const int count : {17, 18, 19, 20, 21, 22, 23, 24, 100}) {
    const Spectrum spectrum = laplacian_spectrum(sphere(1, 4), count);
    for (Eigen::Index k = 1; k < count; ++k) {
      const double l = std::floor(std::sqrt(static_cast<double>(k)));
      EXPECT_NEAR(spectrum.eigenvalues[k], l * (l + 1), 0.06 * l * (l + 1)) << k << " of " << count;
    }
  }
}

TEST(Laplacian, EigenvaluesOfARectangleMatchCosines) {
  const Spectrum spectrum = laplacian_spectrum(test::rectangle(2, 1, 48, 24), 6);
  const double unit = std::numbers::pi * std::numbers::pi;  // of pi^2 (i^2 / 4 + j^2)
  const std::vector<double> expected = {0, unit / 4, unit, unit, unit * 5 / 4, unit * 2};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(spectrum.eigenvalues[static_cast<Eigen::Index>(k)], expected[k], 0.01 * expected[k] + 1e-8) << k;
  }
}

TEST(Laplacian, EigenvectorsSolveTheEigenproblemAndAreOrthonormalByArea) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Laplacian laplacian = cotangent_laplacian(shape);
  const Spectrum spectrum = laplacian_spectrum(shape, 12);
  Eigen::MatrixXd at_nodes(laplacian.mass.size(), 12);
  for (std::size_t v = 0; v < laplacian.node_of.size(); ++v) {
    at_nodes.row(laplacian.node_of[v]) = spectrum.eigenvectors.row(static_cast<Eigen::Index>(v));
  }
  const Eigen::MatrixXd products = at_nodes.transpose() * laplacian.mass.asDiagonal() * at_nodes;
  EXPECT_LT((products - Eigen::MatrixXd::Identity(12, 12)).cwiseAbs().maxCoeff(), 1e-7);
  const Eigen::MatrixXd residual =
      laplacian.stiffness * at_nodes - laplacian.mass.asDiagonal() * at_nodes * spectrum.eigenvalues.asDiagonal();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Laplacian, SpectrumDoesNotChangeWithMotionVertexOrderOrSplitVertices) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Eigen::VectorXd expected = laplacian_spectrum(shape, 10).eigenvalues;
  const Shape moved = test::transformed(test::permuted(shape, 1).shape, 2, test::rotation(4), {3, 2, 1});
  EXPECT_LT((4 * laplacian_spectrum(moved, 10).eigenvalues - expected).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((laplacian_spectrum(test::soup(shape), 10).eigenvalues - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Laplacian, HasOneZeroEigenvaluePerConnectedComponent) {
  const Shape ball = sphere(1, 2);
  const Shape pair = test::joined({ball, test::transformed(ball, 1, Eigen::Matrix3d::Identity(), {4, 0, 0})});
  const Spectrum spectrum = laplacian_spectrum(pair, 8);
  EXPECT_NEAR(spectrum.eigenvalues[1], 0, 1e-8);
  EXPECT_NEAR(spectrum.eigenvalues[2], 2, 0.1);
}

TEST(Laplacian, HasNoMoreEigenvaluesThanVertices) {
  const Shape cube = test::box({1, 1, 1}, 1);
  EXPECT_EQ(laplacian_spectrum(cube, 100).eigenvalues.size(), cube.vertices.rows());
}

TEST(Laplacian, IgnoresDegenerateTrianglesAndUnusedVertices) {
  Shape shape = sphere(1, 2);
  const Eigen::VectorXd expected = laplacian_spectrum(shape, 5).eigenvalues;
  const Eigen::Index unused = shape.vertices.rows();
  shape.vertices.conservativeResize(unused + 1, 3);
  shape.vertices.bottomRows<1>() << 9, 9, 9;
  shape.triangles.conservativeResize(shape.triangles.rows() + 1, 3);
  shape.triangles.bottomRows<1>() << 0, 0, 1;
  const Spectrum spectrum = laplacian_spectrum(shape, 5);
  EXPECT_LT((spectrum.eigenvalues - expected).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_TRUE(spectrum.eigenvectors.row(unused).array().isNaN().all());
}

TEST(Laplacian, ReturnsAdditionalZeroEigenvaluesForFurtherComponents) {
  std::vector<Shape> spheres;
  for (int i = 0; i < 4; ++i) {
    spheres.push_back(test::transformed(sphere(1, 1), 1, Eigen::Matrix3d::Identity(), {3.0 * i, 0, 0}));
  }
  const Shape four = test::joined(spheres);
  const Eigen::VectorXd eigenvalues = laplacian_spectrum(four, 5).eigenvalues;
  ASSERT_EQ(eigenvalues.size(), 4 + 4);
  EXPECT_LT(eigenvalues.head(4).maxCoeff(), 1e-9);
  const double first = laplacian_spectrum(spheres.front(), 2).eigenvalues[1];  // three times each sphere's
  EXPECT_LT((eigenvalues.tail(4).array() - first).abs().maxCoeff(), 1e-6);
}

TEST(Laplacian, SpectrumRefusesThousandsOfComponents) {
  const Shape scales = test::soup(sphere(1, 4));
  Shape separated = scales;
  for (Eigen::Index v = 0; v < separated.vertices.rows(); v += 3) {
    const Eigen::RowVector3d middle = separated.vertices.middleRows<3>(v).colwise().mean();
    for (Eigen::Index k = v; k < v + 3; ++k) separated.vertices.row(k) = 0.1 * middle + 0.9 * separated.vertices.row(k);
  }
  EXPECT_THROW(laplacian_spectrum(separated, 5), InputError);
  EXPECT_EQ(laplacian_spectrum(scales, 5).eigenvalues.size(), 5);  // coincident vertices are welded
}

TEST(Laplacian, RejectsCloudsAndShapesWithoutArea) {
  EXPECT_THROW(laplacian_spectrum(Shape{sphere(1, 1).vertices, {}}, 5), InputError);
  Shape line = test::box({1, 1, 1}, 1);
  line.vertices.rightCols<2>().setZero();
  EXPECT_THROW(laplacian_spectrum(line, 5), InputError);
  EXPECT_THROW(laplacian_spectrum(sphere(1, 1), 0), InputError);
}

}  // namespace
}  // namespace shapegauge
