// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// Triangles for closest-point queries in batches of eight, in single precision. Degenerate triangles are represented
/// by their edges.
class TriangleTable {
 public:
  static constexpr std::size_t batch_size = 8;  ///< number of triangles of a batch

  void resize(std::size_t count);  ///< sets the number of triangles
  void set(std::size_t index, const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c);
  [[nodiscard]] std::size_t size() const { return records_.size(); }

  /// Three-dimensional vectors (or points) and their squared lengths, one per triangle of a batch.
  struct alignas(32) Vectors {
    std::array<float, batch_size> x, y, z, squared;

    [[nodiscard]] Eigen::Vector3d vector(std::size_t i) const {
      return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
    }
    void set(std::size_t i, const Eigen::Vector3d& v) {
      x[i] = static_cast<float>(v.x());
      y[i] = static_cast<float>(v.y());
      z[i] = static_cast<float>(v.z());
    }
  };

  /// Computes the vectors to x from the closest points of a batch of triangles, given by their batch_size indices.
  void vectors_to(const Eigen::Vector3d& x, const std::int32_t* triangles, Vectors& result) const;

  /// Returns the squared distance from x to a triangle.
  [[nodiscard]] double squared_distance(const Eigen::Vector3d& x, std::int32_t triangle) const;

  /// Returns true if x projects into the interior of a triangle and its distance from the triangle's plane is at most
  /// `max_plane_distance`. False for degenerate triangles.
  [[nodiscard]] bool is_over_face(const Eigen::Vector3d& x, std::int32_t triangle, double max_plane_distance) const;

  /// Computes the vectors from the closest points of a batch of triangles to one query point per triangle. The vectors
  /// replace the query points in `points`.
  void vectors_to_each(Vectors& points, const std::int32_t* triangles) const;

  /// Triangle abc as sixteen floats: a, ab, ac, the dual basis of ab and ac in the triangle's plane (NaN if
  /// degenerate), 1 / |bc|^2 (0 if b = c).
  struct alignas(16) Record : std::array<float, 16> {};
  /// Returns the records of all triangles as one array. The table must not be empty.
  [[nodiscard]] const float* records() const { return records_.front().data(); }

 private:
  std::vector<Record> records_;
};

}  // namespace shapegauge
