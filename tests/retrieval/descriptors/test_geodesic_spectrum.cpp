// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/descriptors/geodesic_spectrum.h"
#include "shapegauge/retrieval/descriptors/shape_dna.h"
#include "tests/retrieval/descriptors/default_settings.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Eigen::VectorXf spectrum_of(const Shape& shape) {
  ProxySource source(shape);
  return geodesic_spectrum(source);
}

TEST(DominantEigenvalues, AreTheEigenvaluesOfLargestMagnitude) {
  const Eigen::MatrixXd random = Eigen::MatrixXd::Random(300, 300);
  const Eigen::MatrixXd symmetric = random + random.transpose();
  const auto all = eigen_decomposition(symmetric, Eigen::EigenvaluesOnly);
  std::vector<double> sizes;
  for (const double value : all.eigenvalues()) sizes.push_back(std::abs(value));
  std::sort(sizes.rbegin(), sizes.rend());
  const Eigen::VectorXd found = dominant_eigenvalues(symmetric, 20);
  ASSERT_EQ(found.size(), 20);
  for (std::size_t k = 0; k < 20; ++k) EXPECT_NEAR(found[static_cast<Eigen::Index>(k)], sizes[k], 1e-6 * sizes[0]);
  EXPECT_EQ(dominant_eigenvalues(symmetric.topLeftCorner(5, 5), 20).size(), 5);
}

// By the Funk-Hecke formula the operator whose kernel is the distance on the unit sphere has the eigenvalues
// 2 pi int arccos(t) P_l(t) dt, each 2 l + 1 times: relative to l = 0 they are 1/4, 0, 1/64, 0, 1/256, ...
TEST(GeodesicSpectrum, OfASphereMatchesTheAnalyticEigenvalues) {
  const Eigen::VectorXf found = spectrum_of(test::sphere(2, 5));
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(found[k], std::log(1.0 / 4), 0.03) << k;
  for (Eigen::Index k = 3; k < 10; ++k) EXPECT_NEAR(found[k], std::log(1.0 / 64), 0.15) << k;
}

TEST(GeodesicSpectrum, ChangesNeitherWithScaleNorWithMotion) {
  const Shape shape = test::capsule(0.3, 2, 24, 30);
  const Shape other = test::transformed(shape, 40, test::rotation(2), {1, 2, 3});
  // Another pose has other samples.
  EXPECT_LT((spectrum_of(shape) - spectrum_of(other)).cwiseAbs().mean(), 0.03);
}

TEST(GeodesicSpectrum, OfAPointCloudIsCloseToThatOfItsMesh) {
  const Shape shape = test::capsule(0.3, 2, 24, 30);
  EXPECT_LT((spectrum_of(shape) - spectrum_of(test::random_points(shape, 10000, 1))).cwiseAbs().mean(), 0.05);
}

TEST(GeodesicSpectrum, RepeatsTheLastEigenvalueForMissingEigenvalues) {
  const Eigen::VectorXf found =
      spectrum_of({.vertices = (Points(2, 3) << 0, 0, 0, 1, 0, 0).finished(), .triangles = {}});
  // Two points of equal area at a distance: eigenvalues of either sign and the same size.
  EXPECT_LT(found.cwiseAbs().maxCoeff(), 1e-5);
}

TEST(GeodesicSpectrum, DoesNotChangeWithASharedSurfaceProxy) {
  const Shape shape = test::capsule(0.3, 2, 16, 16);
  const Descriptor& one = descriptors().at("geodesic_spectrum");
  ProxySource shared(shape);
  shared.spectrum(30);
  const DescriptorSettings settings = default_settings(one);
  EXPECT_EQ(one.describe({.shape = shape, .fields = {}, .proxy = &shared}, {}, settings),
            one.describe({.shape = shape, .fields = {}}, {}, settings));
}

TEST(GeodesicSpectrum, RejectsShapesWithoutArea) { EXPECT_THROW(spectrum_of(Shape{}), InputError); }

TEST(ShapeDna, OfTheSurfaceProxyIsCloseToThatOfTheMesh) {
  const Shape shape = test::torus(1, 0.4, 40, 100);
  ProxySource source(shape);
  const Eigen::VectorXf on_mesh = shape_dna(shape);
  const Eigen::VectorXf found = shape_dna_on_proxy(source);
  EXPECT_LT(((found - on_mesh).array() / on_mesh.array()).abs().maxCoeff(), 0.03);
}

}  // namespace
}  // namespace shapegauge
