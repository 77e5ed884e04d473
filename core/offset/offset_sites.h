// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: r offset distance, band width, in cells, of the layer of exterior cells that have sites.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/core/offset/cells_around.h"

namespace shapegauge {

/// Sites, the starting points of searches: samples of the outer offset surface, about one per squared cell edge. A site
/// is the centre of an exterior cell at most `band` cells outside the offset solid, moved towards the closest triangle
/// to a distance of r.
struct OffsetSites {
  /// Sites of up to 64 consecutive blocks of ExteriorGrid::boundary(). Chunks are not copied into one array: for
  /// offsets of a few thousandths there are millions of sites.
  struct Chunk {
    static constexpr std::size_t blocks = 64;       ///< maximum number of blocks of a chunk
    std::vector<float> x, y, z;                     ///< coordinates of the sites, in cells; padded
    std::vector<std::int32_t> triangle;             ///< per site: index of the triangle at the offset distance from it
    std::array<std::uint16_t, blocks + 1> first{};  ///< per block: index of its first site; last entry: number of sites
  };
  std::vector<Chunk> chunks;  ///< sites of all blocks of ExteriorGrid::boundary(), in their order
  /// Per cube of `cube_edge` blocks along each axis: 1 if it contains sites, otherwise 0.
  std::vector<std::uint8_t> occupied;
  std::vector<Eigen::Vector3i> occupied_cubes;      ///< coordinates of the cubes that contain sites
  Eigen::Vector3i cubes = Eigen::Vector3i::Zero();  ///< number of cubes of blocks along each axis of the grid
  static constexpr int cube_edge = 8;               ///< number of blocks of a cube along each axis
  /// Maximum distance, in cells along an axis, of a site from the block of its cell: sites are moved away from the
  /// centres of cells.
  double overhang = 0;

  /// Computes the sites of the exterior cells up to `band` cells outside the offset solid.
  OffsetSites(const ExteriorGrid& exterior, double band, bool parallel);

  /// Maximum number of sites in a chunk. The number of a site is max_in_chunk times the index of its chunk, plus its
  /// index in the chunk.
  static constexpr std::uint32_t max_in_chunk = Chunk::blocks * cells_per_block;
  [[nodiscard]] Eigen::Vector3d position(std::uint32_t site) const {
    const Chunk& chunk = chunks[site / max_in_chunk];
    const std::uint32_t i = site % max_in_chunk;
    return {static_cast<double>(chunk.x[i]), static_cast<double>(chunk.y[i]), static_cast<double>(chunk.z[i])};
  }
  [[nodiscard]] std::int32_t triangle(std::uint32_t site) const {
    return chunks[site / max_in_chunk].triangle[site % max_in_chunk];
  }

  /// Sites of one block of ExteriorGrid::boundary(): a range of a chunk.
  struct BlockSites {
    const Chunk& chunk;
    std::size_t begin, end;           ///< range of indices of the sites in the arrays of the chunk
    std::uint32_t first_site_number;  ///< number of the chunk's first site, as in position()
  };
  /// Returns the sites of a block, given its index in ExteriorGrid::boundary().
  [[nodiscard]] BlockSites sites_of_block(std::size_t block) const {
    const std::size_t c = block / Chunk::blocks;
    const Chunk& chunk = chunks[c];
    const std::size_t i = block % Chunk::blocks;
    return {chunk, chunk.first[i], chunk.first[i + 1], static_cast<std::uint32_t>(c) * max_in_chunk};
  }
};

/// Collects the sites near a group of samples in contiguous arrays, and finds the nearest. Positions are in cells.
class NearbySites {
 public:
  NearbySites(const ExteriorGrid& exterior, const OffsetSites& sites) : exterior_(exterior), sites_(sites) {}

  /// Returns the distance from x to the nearest of all sites; infinite without sites.
  double distance_to_nearest(const Eigen::Vector3d& x);

  /// Replaces the collected sites by all within `reach` of the box, and some that are slightly farther.
  void collect(const Eigen::AlignedBox3d& box, double reach);

  /// Site and its distance from a query point.
  struct Site {
    std::uint32_t site;  ///< number of the site, as in OffsetSites::position()
    float distance;      ///< distance of the site from the query point, in cells
  };
  /// Computes the distances from two points to all collected sites. Returns the distance from each point to the nearest
  /// site; infinite without sites.
  std::array<double, 2> measure(const std::array<Eigen::Vector3d, 2>& points);
  /// Finds the starting points for the search from one of the two points of the last measure() (0 or 1), by ascending
  /// distance. They are sites whose distance exceeds the smallest by at most the margin, each farther than
  /// `min_spacing` from those before it; at most max_count.
  void find_start_sites(std::size_t point, double margin, double min_spacing, std::size_t max_count,
                        std::vector<Site>& found);

 private:
  void collect_blocks(const Eigen::Vector3i& begin, const Eigen::Vector3i& end, const Eigen::AlignedBox3d& box,
                      double squared_reach);
  void collect_row(const Eigen::Vector3i& begin, int end);
  [[nodiscard]] double nearest_in_cube(const Eigen::Vector3i& cube, const Eigen::Vector3d& x, double limit);

  const ExteriorGrid& exterior_;
  const OffsetSites& sites_;
  std::vector<float> x_, y_, z_, squared_scratch_;  ///< coordinates of the collected sites, in cells; squared distances
  std::array<std::vector<float>, 2> squared_;       ///< per measured point: squared distances to the collected sites
  std::array<double, 2> nearest_{};                 ///< per measured point: distance to the nearest site
  /// Numbers of the collected sites; indices of sites within the margin.
  std::vector<std::uint32_t> site_, candidates_;
  std::vector<Site> within_margin_;                      ///< scratch of find_start_sites()
  std::vector<std::pair<double, std::uint32_t>> queue_;  ///< cubes by distance: squared distance and index
};

}  // namespace shapegauge
