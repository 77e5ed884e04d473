#include "shapegauge/core/io/write_ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <string>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/writable_shape.h"

namespace shapegauge {

namespace {

constexpr std::string_view sample_properties =
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double sdf\n";

std::string header_of(const Shape& shape, SampleSite site) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}"
      "element face {}\nproperty list uchar int vertex_indices\n{}end_header\n",
      shape.vertices.rows(), site == SampleSite::vertices ? sample_properties : "", shape.triangles.rows(),
      site == SampleSite::faces ? sample_properties : "");
}

template <typename Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

void append_sample(std::string& bytes, double value, const Colour& colour) {
  for (const std::uint8_t channel : colour) append_little_endian(bytes, channel);
  append_little_endian(bytes, value);
}

void append_triangle(std::string& bytes, const Shape& shape, Eigen::Index triangle) {
  append_little_endian(bytes, std::uint8_t{3});
  for (int corner = 0; corner < 3; ++corner) append_little_endian(bytes, shape.triangles(triangle, corner));
}

}  // namespace

void write_ply(const std::filesystem::path& path, const Shape& shape) {
  require_writable(path, shape);
  const bool has_normals = is_cloud(shape) && shape.normals.rows() > 0;
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      shape.vertices.rows(), has_normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "",
      shape.triangles.rows());
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    for (const double coordinate : shape.vertices.row(i)) append_little_endian(bytes, coordinate);
    if (!has_normals) continue;
    for (const double coordinate : shape.normals.row(i)) append_little_endian(bytes, coordinate);
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) append_triangle(bytes, shape, f);
  write_file_atomically(path, bytes);
}

void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<Colour>& colours) {
  require_writable(path, shape);
  const Eigen::Index samples = site == SampleSite::faces ? shape.triangles.rows() : shape.vertices.rows();
  if (values.size() != samples || colours.size() != static_cast<std::size_t>(samples)) {
    throw InputError(fmt::format("cannot write {}: {} values and {} colours for {} samples", path.string(),
                                 values.size(), colours.size(), samples));
  }
  std::string bytes = header_of(shape, site);
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, shape.vertices(i, axis));
    if (site == SampleSite::vertices) append_sample(bytes, values[i], colours[static_cast<std::size_t>(i)]);
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    append_triangle(bytes, shape, f);
    if (site == SampleSite::faces) append_sample(bytes, values[f], colours[static_cast<std::size_t>(f)]);
  }
  write_file_atomically(path, bytes);
}

}  // namespace shapegauge
