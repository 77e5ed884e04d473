#include "tests/core/random_points.h"

#include <algorithm>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge::test_shapes {

Shape random_points(const Shape& mesh, Eigen::Index count, std::uint64_t seed) {
  std::vector<double> areas_up_to;
  double total = 0;
  for (const double area : triangle_areas(mesh)) areas_up_to.push_back(total += area);
  RandomNumbers random(seed);
  Shape cloud;
  cloud.vertices.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto found = std::ranges::upper_bound(areas_up_to, random.uniform(0, total));
    const auto f = std::min<Eigen::Index>(found - areas_up_to.begin(), mesh.triangles.rows() - 1);
    double u = random.uniform(0, 1);
    double v = random.uniform(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    cloud.vertices.row(i) = (1 - u - v) * mesh.vertices.row(mesh.triangles(f, 0)) +
                            u * mesh.vertices.row(mesh.triangles(f, 1)) + v * mesh.vertices.row(mesh.triangles(f, 2));
  }
  return cloud;
}

}  // namespace shapegauge::test_shapes
