#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// Points of the outer offset surface, about one for each square of a cell's edge: the centre of every exterior cell
/// within the band of the offset solid, moved along the line to its closest triangle until that is r away.
struct OffsetSites {
  /// Of so many of the exterior's boundary blocks in a row. Nothing is copied to where all are: with offsets of a few
  /// thousandths there are millions.
  struct Chunk {
    static constexpr std::size_t blocks = 64;
    std::vector<float> x, y, z;                     ///< padded
    std::vector<std::int32_t> triangle;             ///< that is r away from each
    std::array<std::uint16_t, blocks + 1> first{};  ///< of each block's, and one past the last's
  };
  std::vector<Chunk> chunks;
  /// Cubes of `cube_edge` blocks along each axis: whether any are in each, and all in which there are.
  std::vector<std::uint8_t> occupied;
  std::vector<Eigen::Vector3i> occupied_cubes;
  Eigen::Vector3i cubes = Eigen::Vector3i::Zero();  ///< along each axis
  static constexpr int cube_edge = 8;

  OffsetSites(const ExteriorGrid& exterior, double band, bool parallel);

  /// A site's number is its chunk's times this, and its place in the chunk.
  static constexpr std::uint32_t most_in_chunk = Chunk::blocks * cells_per_block;
  [[nodiscard]] Eigen::Vector3d place(std::uint32_t site) const {
    const Chunk& chunk = chunks[site / most_in_chunk];
    const std::uint32_t i = site % most_in_chunk;
    return {static_cast<double>(chunk.x[i]), static_cast<double>(chunk.y[i]), static_cast<double>(chunk.z[i])};
  }
  [[nodiscard]] std::int32_t triangle(std::uint32_t site) const {
    return chunks[site / most_in_chunk].triangle[site % most_in_chunk];
  }

  /// The sites of one of the exterior's boundary blocks.
  struct OfBlock {
    const Chunk& chunk;
    std::size_t begin, end;       ///< in the chunk
    std::uint32_t number_before;  ///< of the chunk's first site
  };
  [[nodiscard]] OfBlock of_block(std::size_t block) const {
    const std::size_t c = block / Chunk::blocks;
    const Chunk& chunk = chunks[c];
    const std::size_t i = block % Chunk::blocks;
    return {chunk, chunk.first[i], chunk.first[i + 1], static_cast<std::uint32_t>(c) * most_in_chunk};
  }
};

/// The sites near a group of samples, each group's in a row.
class NearbySites {
 public:
  NearbySites(const ExteriorGrid& exterior, const OffsetSites& sites) : exterior_(exterior), sites_(sites) {}

  /// The distance from x to the nearest of all sites, however far; infinite where there are none.
  double distance_to_nearest(const Eigen::Vector3d& x);

  /// Collects those within reach of the box.
  void collect(const Eigen::AlignedBox3d& box, double reach);

  struct Site {
    std::uint32_t site;  ///< its number
    float distance;
  };
  /// The distances from two places to the nearest of the collected sites, infinite where there is none.
  std::array<double, 2> measure(const std::array<Eigen::Vector3d, 2>& places);
  /// Of the sites whose distance from one of the places measured exceeds the nearest one's by less than the margin, in
  /// the order of their distances: the nearest, then those farther than `apart` from all before, up to so many.
  void starts(std::size_t place, double margin, double apart, std::size_t most, std::vector<Site>& found);

 private:
  void collect_row(const Eigen::Vector3i& begin, int end);
  [[nodiscard]] double nearest_in_cube(const Eigen::Vector3i& cube, const Eigen::Vector3d& x, double limit);

  const ExteriorGrid& exterior_;
  const OffsetSites& sites_;
  std::vector<float> x_, y_, z_, of_block_;
  std::array<std::vector<float>, 2> squared_;  ///< distances from the two places
  std::array<double, 2> nearest_{};
  std::vector<std::uint32_t> site_, candidates_;
  std::vector<Site> within_margin_;
  std::vector<std::pair<double, std::uint32_t>> waiting_;  ///< squared distances of cubes and their numbers
};

}  // namespace shapegauge
