#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// Triangles for closest-point queries to eight of them at once, in single precision. Those of no area are
/// their edges.
class TriangleTable {
 public:
  static constexpr std::size_t at_once = 8;

  void resize(std::size_t count);
  void set(std::size_t index, const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c);
  [[nodiscard]] std::size_t size() const { return records_.size(); }

  /// A vector and its squared length for each of the eight.
  struct alignas(32) Vectors {
    std::array<float, at_once> x, y, z, squared;

    [[nodiscard]] Eigen::Vector3d vector(std::size_t i) const {
      return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
    }
    void set(std::size_t i, const Eigen::Vector3d& v) {
      x[i] = static_cast<float>(v.x());
      y[i] = static_cast<float>(v.y());
      z[i] = static_cast<float>(v.z());
    }
  };

  /// The vectors from the closest points of the triangles to x.
  void vectors_to(const Eigen::Vector3d& x, const std::int32_t* triangles, Vectors& result) const;

  /// The squared distance from x to one of them.
  [[nodiscard]] double squared_distance(const Eigen::Vector3d& x, std::int32_t triangle) const;

  /// Whether x is over the face of a triangle, and no farther from its plane than that. Not told of those of no area.
  [[nodiscard]] bool is_over_face(const Eigen::Vector3d& x, std::int32_t triangle, double at_most) const;

  /// Which part of a triangle a point of it lies on.
  enum class Part : std::uint8_t { face, edge, corner };
  struct Place {
    Part part;
    Eigen::Vector3d edge;  ///< its direction, of length 1; zero on faces and corners
  };
  [[nodiscard]] Place place_of(const Eigen::Vector3d& point, std::int32_t triangle) const;

  /// The same for a point for each triangle: the points are replaced.
  void vectors_to_each(Vectors& points, const std::int32_t* triangles) const;

  /// a, ab, ac, the duals of ab and ac in the triangle's plane, 1 / bc^2
  struct alignas(16) Record : std::array<float, 16> {};

 private:
  std::vector<Record> records_;
};

}  // namespace shapegauge
