#include "shapegauge/experiments/results/field_files.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <string>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/write_ply.h"
#include "shapegauge/core/render/colour_map.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/experiments/matrices/npy.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

std::vector<Colour> colours(const Samples& samples, const Eigen::VectorXd& values) {
  const Interval range = value_range({.values = values, .weights = samples.weights}).value_or(Interval{});
  return colours_of(values, range.low, range.high);
}

void write_csv(const fs::path& path, const Shape& /*shape*/, const Samples& samples, const Eigen::VectorXd& values) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "index,sdf,weight\n");
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", i, values[i], samples.weights[i]);
  }
  write_file_atomically(path, {text.data(), text.size()});
}

void write_values(const fs::path& path, const Shape& /*shape*/, const Samples& /*samples*/,
                  const Eigen::VectorXd& values) {
  write_npy_vector(path, values);
}

void write_coloured_mesh(const fs::path& path, const Shape& shape, const Samples& samples,
                         const Eigen::VectorXd& values) {
  write_ply(path, shape, samples.site, values, colours(samples, values));
}

void write_picture(const fs::path& path, const Shape& shape, const Samples& samples, const Eigen::VectorXd& values) {
  write_png(path, render_shape(shape, colours(samples, values), samples.site));
}

}  // namespace

FieldFileWriter field_file_writer(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".csv") return write_csv;
  if (extension == ".npy") return write_values;
  if (extension == ".ply") return write_coloured_mesh;
  if (extension == ".png") return write_picture;
  throw InputError(fmt::format("cannot write {}: the name must end in .csv, .npy, .ply or .png", path.string()));
}

}  // namespace shapegauge
