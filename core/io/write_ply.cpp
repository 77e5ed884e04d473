#include "shapegauge/core/io/write_ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/writable_shape.h"

namespace shapegauge {

namespace {

/// Values and colours of the samples at a site.
struct ColouredValues {
  SampleSite site;
  const Eigen::VectorXd& values;
  const std::vector<Colour>& colours;
};

std::string header_of(const Shape& shape, const ColouredValues* samples) {
  constexpr std::string_view of_samples =
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double sdf\n";
  const auto properties_at = [&](SampleSite site) { return samples && samples->site == site ? of_samples : ""; };
  std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}{}",
      shape.vertices.rows(),
      has_cloud_normals(shape) ? "property double nx\nproperty double ny\nproperty double nz\n" : "",
      properties_at(SampleSite::vertices));
  if (!is_cloud(shape)) {
    header += fmt::format("element face {}\nproperty list uchar int vertex_indices\n{}", shape.triangles.rows(),
                          properties_at(SampleSite::faces));
  }
  return header + "end_header\n";
}

template <typename Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

void append_vector(std::string& bytes, const Eigen::RowVector3d& vector) {
  for (const double component : vector) append_little_endian(bytes, component);
}

void append_sample(std::string& bytes, const ColouredValues& samples, Eigen::Index i) {
  for (const std::uint8_t channel : samples.colours[static_cast<std::size_t>(i)]) append_little_endian(bytes, channel);
  append_little_endian(bytes, samples.values[i]);
}

/// The file, with samples where there are any.
void write(const std::filesystem::path& path, const Shape& shape, const ColouredValues* samples) {
  require_writable(path, shape);
  std::string bytes = header_of(shape, samples);
  const bool at_vertices = samples && samples->site == SampleSite::vertices;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    append_vector(bytes, shape.vertices.row(i));
    if (has_cloud_normals(shape)) append_vector(bytes, shape.normals.row(i));
    if (at_vertices) append_sample(bytes, *samples, i);
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    append_little_endian(bytes, std::uint8_t{3});
    for (int corner = 0; corner < 3; ++corner) append_little_endian(bytes, shape.triangles(f, corner));
    if (samples && !at_vertices) append_sample(bytes, *samples, f);
  }
  write_file_atomically(path, bytes);
}

}  // namespace

void write_ply(const std::filesystem::path& path, const Shape& shape) { write(path, shape, nullptr); }

void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<Colour>& colours) {
  const Eigen::Index samples = site == SampleSite::faces ? shape.triangles.rows() : shape.vertices.rows();
  if (values.size() != samples || colours.size() != static_cast<std::size_t>(samples)) {
    throw InputError(fmt::format("cannot write {}: {} values and {} colours for {} samples", path.string(),
                                 values.size(), colours.size(), samples));
  }
  const ColouredValues coloured{.site = site, .values = values, .colours = colours};
  write(path, shape, &coloured);
}

}  // namespace shapegauge
