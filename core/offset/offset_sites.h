// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Samples of the outer offset surface, about one per squared cell edge: the centre of each exterior cell within the
/// band around the offset solid, moved towards its closest triangle to a distance of r.
struct OffsetSites {
  /// Sites of consecutive boundary blocks. Chunks are not copied into one array: for offsets of a few thousandths there
  /// are millions of sites.
  struct Chunk {
    static constexpr std::size_t blocks = 64;
    std::vector<float> x, y, z;                     ///< padded
    std::vector<std::int32_t> triangle;             ///< triangle at a distance of r from each
    std::array<std::uint16_t, blocks + 1> first{};  ///< per block: index of its first site; one more entry at the end
  };
  std::vector<Chunk> chunks;
  /// Occupancy of cubes of `cube_edge` blocks along each axis, and the list of occupied cubes.
  std::vector<std::uint8_t> occupied;
  std::vector<Eigen::Vector3i> occupied_cubes;
  Eigen::Vector3i cubes = Eigen::Vector3i::Zero();  ///< number along each axis
  static constexpr int cube_edge = 8;
  /// Maximum distance of a site from its block along an axis, in cells: it is moved away from the centre of a cell.
  double overhang = 0;

  OffsetSites(const ExteriorGrid& exterior, double band, bool parallel);

  /// A site's number is its chunk's index times this, plus its index in the chunk.
  static constexpr std::uint32_t max_in_chunk = Chunk::blocks * cells_per_block;
  [[nodiscard]] Eigen::Vector3d position(std::uint32_t site) const {
    const Chunk& chunk = chunks[site / max_in_chunk];
    const std::uint32_t i = site % max_in_chunk;
    return {static_cast<double>(chunk.x[i]), static_cast<double>(chunk.y[i]), static_cast<double>(chunk.z[i])};
  }
  [[nodiscard]] std::int32_t triangle(std::uint32_t site) const {
    return chunks[site / max_in_chunk].triangle[site % max_in_chunk];
  }

  /// Sites of a boundary block of the exterior.
  struct BlockSites {
    const Chunk& chunk;
    std::size_t begin, end;       ///< indices in the chunk
    std::uint32_t number_before;  ///< number of the chunk's first site
  };
  [[nodiscard]] BlockSites sites_of_block(std::size_t block) const {
    const std::size_t c = block / Chunk::blocks;
    const Chunk& chunk = chunks[c];
    const std::size_t i = block % Chunk::blocks;
    return {chunk, chunk.first[i], chunk.first[i + 1], static_cast<std::uint32_t>(c) * max_in_chunk};
  }
};

/// Sites near a group of samples, in contiguous arrays.
class NearbySites {
 public:
  NearbySites(const ExteriorGrid& exterior, const OffsetSites& sites) : exterior_(exterior), sites_(sites) {}

  /// Returns the distance from x to the nearest of all sites; infinite without sites.
  double distance_to_nearest(const Eigen::Vector3d& x);

  /// Collects the sites within `reach` of the box.
  void collect(const Eigen::AlignedBox3d& box, double reach);

  struct Site {
    std::uint32_t site;  ///< number of the site
    float distance;
  };
  /// Computes the distances from two points to all collected sites, and returns those to the nearest; infinite without
  /// sites.
  std::array<double, 2> measure(const std::array<Eigen::Vector3d, 2>& points);
  /// Returns starting points for the search from one of the measured points, by ascending distance: sites whose
  /// distance exceeds the smallest by less than the margin, each farther than `apart` from those before; at most
  /// max_count.
  void start_sites(std::size_t point, double margin, double apart, std::size_t max_count, std::vector<Site>& found);

 private:
  void collect_blocks(const Eigen::Vector3i& begin, const Eigen::Vector3i& end, const Eigen::AlignedBox3d& box,
                      double squared_reach);
  void collect_row(const Eigen::Vector3i& begin, int end);
  [[nodiscard]] double nearest_in_cube(const Eigen::Vector3i& cube, const Eigen::Vector3d& x, double limit);

  const ExteriorGrid& exterior_;
  const OffsetSites& sites_;
  std::vector<float> x_, y_, z_, squared_scratch_;
  std::array<std::vector<float>, 2> squared_;  ///< squared distances from the two points
  std::array<double, 2> nearest_{};
  std::vector<std::uint32_t> site_, candidates_;
  std::vector<Site> within_margin_;
  std::vector<std::pair<double, std::uint32_t>> queue_;  ///< squared distances of cubes, with their indices
};

}  // namespace shapegauge
