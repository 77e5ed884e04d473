#include "shapegauge/core/offset/block_grid.h"

#include <array>
#include <cmath>

namespace shapegauge {

BlockGrid::BlockGrid(const Eigen::AlignedBox3d& bounds, double offset, double h) : cell(h), r(offset / h) {
  // Two cells above r are as far as anybody looks for points, and whole blocks are looked at.
  const double margin = block_edge * h * (std::ceil((r + 2) / block_edge) + 1);
  origin = bounds.min() - Eigen::Vector3d::Constant(margin);
  const Eigen::Vector3d extent = bounds.sizes() + Eigen::Vector3d::Constant(2 * margin);
  blocks = (extent / (block_edge * h)).array().ceil().cast<int>();
}

std::size_t BlockGrid::block_count() const {
  return static_cast<std::size_t>(blocks.x()) * static_cast<std::size_t>(blocks.y()) *
         static_cast<std::size_t>(blocks.z());
}

void dilate(const BlockGrid& grid, std::vector<std::uint8_t>& marked, int reach) {
  std::vector<std::uint8_t> line;
  const std::array<std::size_t, 3> size{static_cast<std::size_t>(grid.blocks.x()),
                                        static_cast<std::size_t>(grid.blocks.y()),
                                        static_cast<std::size_t>(grid.blocks.z())};
  const std::array<std::size_t, 3> stride{1, size[0], size[0] * size[1]};
  for (int step = 0; step < reach; ++step) {
    std::vector<std::uint8_t> wider;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wider = marked;
      const std::size_t s = stride[axis];
      const std::size_t span = s * size[axis];
      for (std::size_t start = 0; start < marked.size(); start += span) {
        for (std::size_t i = start + s; i < start + span; ++i) {
          wider[i] |= marked[i - s];
          wider[i - s] |= marked[i];
        }
      }
      marked.swap(wider);
    }
  }
}

}  // namespace shapegauge
