// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/offset_sites.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

constexpr double band_of_sites = 0.9;
constexpr double spacing_of_points = 0.75;

struct SiteGrid {
  SiteGrid(const Shape& mesh, double offset, double band = band_of_sites, bool parallel = false)
      : shape(mesh),
        grid(bounding_box(mesh), offset, offset / 3),
        surface(grid, mesh, spacing_of_points, parallel),
        exterior(grid, surface, band_of_sites, parallel),
        sites(exterior, band, parallel) {}

  [[nodiscard]] double distance_to_triangle(std::int32_t triangle, const Eigen::Vector3d& x) const {
    return (closest_point(triangle_in_cells(grid, shape, triangle), x) - x).norm();
  }
  [[nodiscard]] double distance_to_surface(const Eigen::Vector3d& x) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int32_t f = 0; f < shape.triangles.rows(); ++f) nearest = std::min(nearest, distance_to_triangle(f, x));
    return nearest;
  }

  Shape shape;
  BlockGrid grid;
  GridSurface surface;
  ExteriorGrid exterior;
  OffsetSites sites;
};

/// The numbers of all sites, by boundary block.
std::vector<std::vector<std::uint32_t>> sites_by_block(const SiteGrid& all) {
  std::vector<std::vector<std::uint32_t>> numbers(all.exterior.boundary().size());
  for (std::size_t block = 0; block < numbers.size(); ++block) {
    const OffsetSites::BlockSites found = all.sites.sites_of_block(block);
    for (std::size_t i = found.begin; i < found.end; ++i) {
      numbers[block].push_back(found.first_site_number + static_cast<std::uint32_t>(i));
    }
  }
  return numbers;
}

std::vector<std::uint32_t> all_sites(const SiteGrid& all) {
  std::vector<std::uint32_t> numbers;
  for (const auto& block : sites_by_block(all)) numbers.insert(numbers.end(), block.begin(), block.end());
  return numbers;
}

TEST(OffsetSites, AreOnTheOffsetSurface) {
  const SiteGrid all(test::torus(1, 0.4, 24, 16), 0.15);
  const std::vector<std::uint32_t> numbers = all_sites(all);
  ASSERT_GT(numbers.size(), 1000U);
  const double r = all.grid.r;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Eigen::Vector3d position = all.sites.position(numbers[i]);
    EXPECT_NEAR(all.distance_to_triangle(all.sites.triangle(numbers[i]), position), r, 1e-4);
    if (i % 20 != 0) continue;
    // The triangle of the nearest point is hardly farther than the closest one, see BlockDistances.
    EXPECT_GT(all.distance_to_surface(position), r - spacing_of_points * spacing_of_points / (2 * r));
  }
}

TEST(OffsetSites, AreExteriorCellCentresMovedToTheOffsetDistance) {
  const SiteGrid all(test::box({1, 0.8, 0.6}, 1), 0.2);
  const std::vector<std::vector<std::uint32_t>> numbers = sites_by_block(all);
  const double r = all.grid.r;
  std::size_t cells = 0;
  for (std::size_t number = 0; number < numbers.size(); ++number) {
    const Eigen::Vector3i block = all.grid.block_at(all.exterior.boundary()[number].index);
    // The definition: the centre of each cell, moved to a distance of r from the surface.
    std::vector<Eigen::Vector3d> expected;
    bool is_certain = true;
    for (int bit = 0; bit < cells_per_block; ++bit) {
      if ((all.exterior.boundary_cells(number) >> bit & 1U) == 0) continue;
      const Eigen::Vector3d centre =
          (block_edge * block + Eigen::Vector3i(bit % 4, bit / 4 % 4, bit / 16)).cast<double>().array() + 0.5;
      Eigen::Vector3d nearest = Eigen::Vector3d::Constant(1e9);
      for (std::int32_t f = 0; f < all.shape.triangles.rows(); ++f) {
        const Eigen::Vector3d point = closest_point(triangle_in_cells(all.grid, all.shape, f), centre);
        if ((point - centre).norm() < (nearest - centre).norm()) nearest = point;
      }
      const double distance = (nearest - centre).norm();
      if (std::abs(distance - r - band_of_sites) < 1e-4) is_certain = false;
      if (distance < r + band_of_sites) expected.emplace_back(nearest + r / distance * (centre - nearest));
    }
    if (!is_certain) continue;
    ASSERT_EQ(numbers[number].size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LT((all.sites.position(numbers[number][i]) - expected[i]).norm(), 1e-3);
    }
    cells += expected.size();
  }
  EXPECT_GT(cells, 1000U);
}

TEST(OffsetSites, OfASphereAreOnePerCellInTheBandBeyondTheOffset) {
  const SiteGrid all(test::sphere(1, 4), 0.1);
  const double inner = (1 + 0.1) / all.grid.cell;
  const double outer = inner + band_of_sites;
  const double volume = 4.0 / 3 * std::numbers::pi * (std::pow(outer, 3) - std::pow(inner, 3));
  EXPECT_NEAR(static_cast<double>(all_sites(all).size()) / volume, 1, 0.02);
}

TEST(OffsetSites, OccupiedCubesAreExactlyThoseThatContainSites) {
  const SiteGrid all(test::torus(1, 0.4, 24, 16), 0.07);
  const std::vector<std::vector<std::uint32_t>> numbers = sites_by_block(all);
  const Eigen::Vector3i cubes = all.sites.cubes;
  EXPECT_TRUE((OffsetSites::cube_edge * cubes.array() >= all.grid.blocks.array()).all());
  EXPECT_TRUE((OffsetSites::cube_edge * (cubes.array() - 1) < all.grid.blocks.array()).all());
  const auto index = [&](const Eigen::Vector3i& cube) {
    const int number = (cube.z() * cubes.y() + cube.y()) * cubes.x() + cube.x();
    return static_cast<std::size_t>(number);
  };
  std::vector<std::uint8_t> expected(static_cast<std::size_t>(cubes.prod()), 0);
  for (std::size_t block = 0; block < numbers.size(); ++block) {
    if (numbers[block].empty()) continue;
    expected[index(all.grid.block_at(all.exterior.boundary()[block].index) / OffsetSites::cube_edge)] = 1;
  }
  EXPECT_EQ(all.sites.occupied, expected);
  std::vector<std::uint8_t> listed(expected.size(), 0);
  for (const Eigen::Vector3i& cube : all.sites.occupied_cubes) ++listed[index(cube)];
  EXPECT_EQ(listed, expected) << "each once";
  EXPECT_GT(std::ranges::count(expected, 0), 0);
}

TEST(OffsetSites, AreTheSameOnAnyNumberOfThreads) {
  const Shape torus = test::torus(1, 0.4, 24, 16);
  const SiteGrid serial(torus, 0.1, band_of_sites, false);
  const SiteGrid parallel(torus, 0.1, band_of_sites, true);
  const std::vector<std::uint32_t> numbers = all_sites(serial);
  ASSERT_EQ(all_sites(parallel), numbers);
  for (const std::uint32_t site : numbers) {
    EXPECT_EQ(serial.sites.position(site), parallel.sites.position(site));
    EXPECT_EQ(serial.sites.triangle(site), parallel.sites.triangle(site));
  }
}

Eigen::Vector3d random_position(RandomNumbers& random, const BlockGrid& grid, double margin) {
  Eigen::Vector3d x;
  for (int k = 0; k < 3; ++k) x[k] = random.uniform(-margin, block_edge * grid.blocks[k] + margin);
  return x;
}

double nearest_site(const SiteGrid& all, const std::vector<std::uint32_t>& numbers, const Eigen::Vector3d& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t site : numbers) nearest = std::min(nearest, (all.sites.position(site) - x).norm());
  return nearest;
}

TEST(NearbySites, DistanceToTheNearestMatchesExhaustiveSearch) {
  const SiteGrid all(test::torus(1, 0.4, 24, 16), 0.07);
  const std::vector<std::uint32_t> numbers = all_sites(all);
  NearbySites nearby(all.exterior, all.sites);
  RandomNumbers random(1);
  for (int round = 0; round < 150; ++round) {
    const Eigen::Vector3d x = random_position(random, all.grid, 20);
    EXPECT_NEAR(nearby.distance_to_nearest(x), nearest_site(all, numbers, x), 1e-3);
  }
}

TEST(NearbySites, DistanceIsInfiniteIfThereAreNoSites) {
  const SiteGrid none(test::sphere(1, 2), 0.2, -1);
  ASSERT_TRUE(all_sites(none).empty());
  NearbySites nearby(none.exterior, none.sites);
  EXPECT_EQ(nearby.distance_to_nearest({10, 10, 10}), std::numeric_limits<double>::infinity());
  nearby.collect({Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(100)}, 10);
  for (const double distance : nearby.measure({Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)})) {
    EXPECT_EQ(distance, std::numeric_limits<double>::infinity());
  }
  std::vector<NearbySites::Site> starts{{1, 1}};
  nearby.find_start_sites(0, 1, 1, 10, starts);
  EXPECT_TRUE(starts.empty());
}

TEST(NearbySites, CollectAllSitesWithinADistanceOfABox) {
  const SiteGrid all(test::torus(1, 0.4, 24, 16), 0.07);
  const std::vector<std::uint32_t> numbers = all_sites(all);
  NearbySites nearby(all.exterior, all.sites);
  RandomNumbers random(2);
  for (int round = 0; round < 60; ++round) {
    Eigen::AlignedBox3d box(random_position(random, all.grid, 0));
    box.extend(box.min() + Eigen::Vector3d{random.uniform(0, 5), random.uniform(0, 5), random.uniform(0, 5)});
    const double reach = random.uniform(1, 20);
    nearby.collect(box, reach);
    const Eigen::Vector3d within = (box.min() + 2 * box.max()) / 3;
    const std::array<Eigen::Vector3d, 2> points{box.min(), within};
    const std::array<double, 2> distances = nearby.measure(points);
    for (std::size_t i = 0; i < 2; ++i) {
      const double nearest = nearest_site(all, numbers, points[i]);
      if (nearest < reach) {
        EXPECT_NEAR(distances[i], nearest, 1e-3);
      } else {
        EXPECT_GT(distances[i], nearest - 1e-3);
      }
    }
    // All of them, not the nearest alone; of coincident sites the first.
    std::vector<NearbySites::Site> found;
    nearby.find_start_sites(0, 1e6, 0, numbers.size(), found);
    std::set<std::array<double, 3>> collected;
    const auto key = [&](std::uint32_t site) {
      const Eigen::Vector3d at = all.sites.position(site);
      return std::array{at.x(), at.y(), at.z()};
    };
    for (const NearbySites::Site& site : found) collected.insert(key(site.site));
    for (const std::uint32_t site : numbers) {
      if (box.exteriorDistance(all.sites.position(site)) > reach - 1e-3) continue;
      EXPECT_TRUE(collected.contains(key(site)));
    }
  }
}

TEST(NearbySites, StartSitesAreNearThePointAndFarFromEachOther) {
  const SiteGrid all(test::torus(1, 0.4, 24, 16), 0.1);
  const std::vector<std::uint32_t> numbers = all_sites(all);
  NearbySites nearby(all.exterior, all.sites);
  // From the middle of the hole, from the torus and from near its offset.
  std::size_t most = 0;
  for (const Eigen::Vector3d& x :
       {Eigen::Vector3d(0.1, 0, 0), Eigen::Vector3d(1, 0.1, 0), Eigen::Vector3d(0.45, 0, 0)}) {
    const Eigen::Vector3d position = all.grid.to_cells(x);
    nearby.collect({Eigen::Vector3d::Zero(), all.grid.blocks.cast<double>() * block_edge}, 1);
    const std::array<double, 2> nearest = nearby.measure({Eigen::Vector3d::Zero(), position});
    for (const double margin : {0.5, 2.0, 6.0}) {
      for (const double spacing : {0.5, 3.0}) {
        constexpr std::size_t max_count = 40;
        std::vector<NearbySites::Site> starts;
        nearby.find_start_sites(1, margin, spacing, max_count, starts);
        ASSERT_FALSE(starts.empty());
        ASSERT_LE(starts.size(), max_count);
        most = std::max(most, starts.size());
        EXPECT_NEAR(static_cast<double>(starts.front().distance), nearest[1], 1e-4);
        for (std::size_t i = 0; i < starts.size(); ++i) {
          const Eigen::Vector3d start = all.sites.position(starts[i].site);
          EXPECT_NEAR(static_cast<double>(starts[i].distance), (start - position).norm(), 1e-3);
          EXPECT_LT(starts[i].distance, nearest[1] + margin + 1e-4);
          for (std::size_t k = 0; k < i; ++k) {
            EXPECT_LE(starts[k].distance, starts[i].distance);
            EXPECT_GT((all.sites.position(starts[k].site) - start).norm(), spacing - 1e-4);
          }
        }
        // A site that is not among them is near one that is no farther, or farther than the last of a full list.
        for (const std::uint32_t site : numbers) {
          const Eigen::Vector3d at = all.sites.position(site);
          const double distance = (at - position).norm();
          if (distance > nearest[1] + margin - 1e-3) continue;
          const bool is_represented = std::ranges::any_of(starts, [&](const NearbySites::Site& start) {
            return static_cast<double>(start.distance) <= distance + 1e-3 &&
                   (all.sites.position(start.site) - at).norm() <= spacing + 1e-3;
          });
          const bool is_beyond =
              starts.size() == max_count && distance > static_cast<double>(starts.back().distance) - 1e-3;
          EXPECT_TRUE(is_represented || is_beyond) << site;
        }
      }
    }
  }
  EXPECT_GT(most, 10U);
}

}  // namespace
}  // namespace shapegauge
