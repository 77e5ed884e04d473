// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/silhouette.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <mutex>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

/// Resolution of corners in fractions of a pixel: integer coordinates make edge tests exact.
constexpr std::int32_t steps_per_pixel = 256;

/// Point of an image, in steps.
struct ImagePoint {
  std::int32_t x;
  std::int32_t y;
};

/// Returns the first pixel whose centre is at or beyond a coordinate, and the last whose centre is not.
std::int32_t first_centre_from(std::int32_t low) {
  return (low + steps_per_pixel / 2 - 1) / steps_per_pixel;  // `low` is not negative
}
std::int32_t last_centre_to(std::int32_t high) { return (high + steps_per_pixel / 2) / steps_per_pixel - 1; }

/// Directed edge function: `value` is positive on its left, and changes by a constant per pixel.
struct ImageEdge {
  std::int64_t per_column;
  std::int64_t per_row;
  std::int64_t value;  ///< at the centre of the first pixel of a row

  ImageEdge(const ImagePoint& from, const ImagePoint& to, std::int32_t column, std::int32_t row) {
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    const std::int64_t x = std::int64_t{column} * steps_per_pixel + steps_per_pixel / 2 - from.x;
    const std::int64_t y = std::int64_t{row} * steps_per_pixel + steps_per_pixel / 2 - from.y;
    value = dx * y - dy * x;
    per_column = -dy * steps_per_pixel;
    per_row = dx * steps_per_pixel;
  }
};

/// Binary image.
class Canvas {
 public:
  explicit Canvas(int pixels)
      : pixels_(pixels), image_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), 0) {}

  void draw_point(const ImagePoint& at) {
    image_[index(std::min(at.x / steps_per_pixel, pixels_ - 1), std::min(at.y / steps_per_pixel, pixels_ - 1))] = 1;
  }

  /// Draws a triangle. The boxes of most triangles of fine meshes contain no pixel centre.
  void draw_triangle(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c) {
    const std::int32_t left = first_centre_from(std::min(std::min(a.x, b.x), c.x));
    const std::int32_t right = last_centre_to(std::max(std::max(a.x, b.x), c.x));
    if (left > right) return;
    const std::int32_t top = first_centre_from(std::min(std::min(a.y, b.y), c.y));
    const std::int32_t bottom = last_centre_to(std::max(std::max(a.y, b.y), c.y));
    if (top > bottom) return;
    if (is_filled({left, top}, {right, bottom})) return;
    fill(a, b, c, {left, top}, {right, bottom});
  }

  std::vector<std::uint8_t> take() { return std::move(image_); }

 private:
  [[nodiscard]] std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(x);
  }

  /// Returns true if all pixels of a box are filled, as most are behind the first layer of a surface.
  [[nodiscard]] bool is_filled(const ImagePoint& first, const ImagePoint& last) const {
    for (std::int32_t y = first.y; y <= last.y; ++y) {
      for (std::size_t k = index(first.x, y); k <= index(last.x, y); ++k) {
        if (image_[k] == 0) return false;
      }
    }
    return true;
  }

  /// Fills a triangle. `first` and `last` are the corner pixels of its box.
  void fill(const ImagePoint& a, ImagePoint b, ImagePoint c, const ImagePoint& first, const ImagePoint& last) {
    const auto twice_area = [&] {
      return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
             (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    };
    if (twice_area() == 0) return;
    if (twice_area() < 0) std::swap(b, c);
    std::array<ImageEdge, 3> edges{ImageEdge(a, b, first.x, first.y), ImageEdge(b, c, first.x, first.y),
                                   ImageEdge(c, a, first.x, first.y)};
    for (std::int32_t y = first.y; y <= last.y; ++y) {
      std::array<std::int64_t, 3> at = {edges[0].value, edges[1].value, edges[2].value};
      std::uint8_t* pixel = &image_[index(first.x, y)];
      for (std::int32_t x = first.x; x <= last.x; ++x, ++pixel) {
        if ((at[0] | at[1] | at[2]) >= 0) *pixel = 1;  // none is negative
        for (std::size_t k = 0; k < 3; ++k) at[k] += edges[k].per_column;
      }
      for (ImageEdge& edge : edges) edge.value += edge.per_row;
    }
  }

  int pixels_;
  std::vector<std::uint8_t> image_;
};

constexpr int highest_order = 10;

/// Order and repetition of a Zernike polynomial.
struct ZernikeIndex {
  int order;
  int repetition;
};

std::array<ZernikeIndex, zernike_moments> zernike_indices() {
  std::array<ZernikeIndex, zernike_moments> indices{};
  std::size_t next = 0;
  for (int order = 1; order <= highest_order; ++order) {
    for (int repetition = order % 2; repetition <= order; repetition += 2) indices[next++] = {order, repetition};
  }
  return indices;
}

double factorial(int n) { return std::tgamma(n + 1.0); }

/// Radial polynomial with precomputed coefficients.
class RadialPolynomial {
 public:
  explicit RadialPolynomial(ZernikeIndex index) : order_(index.order) {
    for (int s = 0; s <= (index.order - index.repetition) / 2; ++s) {
      const double coefficient =
          factorial(index.order - s) / (factorial(s) * factorial((index.order + index.repetition) / 2 - s) *
                                        factorial((index.order - index.repetition) / 2 - s));
      coefficients_.push_back((s % 2 == 0 ? 1 : -1) * coefficient);
    }
  }

  /// Evaluates the polynomial from the powers of the radius.
  double operator()(const std::array<double, highest_order + 1>& powers) const {
    double sum = 0;
    auto power = static_cast<std::size_t>(order_);
    for (const double coefficient : coefficients_) {
      sum += coefficient * powers[power];
      power -= 2;
    }
    return sum;
  }

 private:
  int order_;
  std::vector<double> coefficients_;
};

/// Pixel of an image, or a step.
struct Pixel {
  int x;
  int y;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// Run of adjacent filled pixels in a row: columns [first, end).
struct Run {
  int row;
  int first;
  int end;
};

/// Returns the runs of an image, in reading order.
std::vector<Run> runs_of(std::span<const std::uint8_t> image, int pixels) {
  std::vector<Run> runs;
  for (int row = 0; row < pixels; ++row) {
    const auto line = image.subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels),
                                    static_cast<std::size_t>(pixels));
    for (auto at = line.begin(); (at = std::find(at, line.end(), 1)) != line.end();) {
      const auto end = std::find(at, line.end(), 0);
      runs.push_back({row, static_cast<int>(at - line.begin()), static_cast<int>(end - line.begin())});
      at = end;
    }
  }
  return runs;
}

/// Returns the first run, in reading order, of each connected component (8 neighbours).
std::vector<Run> first_runs_of_parts(const std::vector<Run>& runs) {
  std::vector<std::size_t> earlier(runs.size());  // a run of the same part, the first of it points to itself
  std::iota(earlier.begin(), earlier.end(), std::size_t{0});
  const auto first_of = [&](std::size_t i) {
    while (earlier[i] != i) i = earlier[i] = earlier[earlier[i]];
    return i;
  };
  std::size_t above = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    while (runs[above].row < runs[i].row - 1 || (runs[above].row < runs[i].row && runs[above].end < runs[i].first)) {
      ++above;
    }
    for (std::size_t k = above; runs[k].row < runs[i].row && runs[k].first <= runs[i].end; ++k) {
      const std::size_t one = first_of(i);
      const std::size_t other = first_of(k);
      earlier[std::max(one, other)] = std::min(one, other);
    }
  }
  std::vector<Run> firsts;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (earlier[i] == i) firsts.push_back(runs[i]);
  }
  return firsts;
}

/// Traces outlines in a binary image.
class Outliner {
 public:
  Outliner(std::span<const std::uint8_t> image, int pixels) : image_(image), pixels_(pixels) {}

  /// Returns the longest outline of a connected component (ties: the first).
  [[nodiscard]] std::vector<Pixel> longest(const std::vector<Run>& runs) const {
    std::vector<Pixel> longest;
    for (const Run& first : first_runs_of_parts(runs)) {
      std::vector<Pixel> outline = follow({first.first, first.row});
      if (outline.size() > longest.size()) longest = std::move(outline);
    }
    return longest;
  }

 private:
  static constexpr std::array<Pixel, 8> around = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

  [[nodiscard]] bool filled(Pixel p) const {
    return p.x >= 0 && p.y >= 0 && p.x < pixels_ && p.y < pixels_ &&
           image_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(p.x)] !=
               0;
  }

  /// Applies Moore's neighbour tracing from a component's first pixel in reading order, until its first step recurs.
  [[nodiscard]] std::vector<Pixel> follow(Pixel start) const {
    std::vector<Pixel> outline;
    std::size_t direction = 0;  // of the last step
    const auto step = [&](Pixel from) {
      for (std::size_t turn = 0; turn < around.size(); ++turn) {
        const std::size_t next = (direction + 5 + turn) % around.size();  // first the one after where it came from
        const Pixel to{from.x + around[next].x, from.y + around[next].y};
        if (!filled(to)) continue;
        direction = next;
        return to;
      }
      return from;
    };
    Pixel second = start;
    for (Pixel here = start;;) {
      const Pixel next = step(here);
      if (outline.empty())
        second = next;
      else if (here == start && next == second)
        break;
      outline.push_back(here);
      if (next == here) break;  // a single pixel
      here = next;
    }
    return outline;
  }

  std::span<const std::uint8_t> image_;
  int pixels_;
};

/// Returns `count` distances of a closed outline from its centroid, at equal steps along it.
std::vector<double> distances_along(const std::vector<Pixel>& outline, std::size_t count) {
  std::vector<double> along = {0};
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
  const auto point = [&](std::size_t i) {
    const Pixel& pixel = outline[i % outline.size()];
    return Eigen::Vector2d(pixel.x, pixel.y);
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double step = (point(i + 1) - point(i)).norm();
    centroid += step * (point(i) + point(i + 1)) / 2;
    along.push_back(along.back() + step);
  }
  centroid /= along.back();
  std::vector<double> distances;
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double at = along.back() * static_cast<double>(k) / static_cast<double>(count);
    while (along[i + 1] <= at) ++i;
    const double share = (at - along[i]) / (along[i + 1] - along[i]);
    distances.push_back(((1 - share) * point(i) + share * point(i + 1) - centroid).norm());
  }
  return distances;
}

}  // namespace

std::vector<std::uint8_t> silhouette(const Eigen::Matrix3Xf& vertices, const Triangles& triangles,
                                     const Eigen::Matrix3d& rotation, int pixels) {
  const float scale = static_cast<float>(pixels * steps_per_pixel) / 2;
  const Eigen::Matrix<float, 2, 3> across = rotation.topRows<2>().cast<float>() * scale;
  const Eigen::Matrix<std::int32_t, 2, Eigen::Dynamic> seen =
      ((across * vertices).array() + (scale + 0.5F)).max(0.0F).min(2 * scale).cast<std::int32_t>().matrix();
  const auto at = [&](std::int32_t vertex) { return ImagePoint{seen(0, vertex), seen(1, vertex)}; };
  Canvas canvas(pixels);
  for (std::int32_t v = 0; v < seen.cols(); ++v) canvas.draw_point(at(v));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    canvas.draw_triangle(at(triangles(f, 0)), at(triangles(f, 1)), at(triangles(f, 2)));
  }
  return canvas.take();
}

SilhouetteFeatures::SilhouetteFeatures(int pixels) : pixels_(pixels) {
  const Eigen::Index side = pixels;
  sums_.setZero(side * (side + 1), 2 * zernike_moments);
  const std::array<ZernikeIndex, zernike_moments> indices = zernike_indices();
  const std::vector<RadialPolynomial> radial(indices.begin(), indices.end());
  const double pixel_area = 4.0 / (static_cast<double>(pixels) * pixels);
  for (Eigen::Index y = 0; y < side; ++y) {
    Eigen::Matrix<double, 1, 2 * zernike_moments> sum = Eigen::Matrix<double, 1, 2 * zernike_moments>::Zero();
    for (Eigen::Index x = 0; x < side; ++x) {
      const std::complex<double> position((2.0 * static_cast<double>(x) + 1) / pixels - 1,
                                          (2.0 * static_cast<double>(y) + 1) / pixels - 1);
      const double radius = std::abs(position);
      const double angle = std::arg(position);
      std::array<double, highest_order + 1> powers{};
      for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = std::pow(radius, static_cast<int>(k));
      for (std::size_t k = 0; radius <= 1 && k < zernike_moments; ++k) {
        const double factor = (indices[k].order + 1) / std::numbers::pi * pixel_area;
        // The radial polynomial may be negative, which std::polar() does not permit.
        const std::complex<double> value = factor * radial[k](powers) * std::polar(1.0, -indices[k].repetition * angle);
        const auto column = static_cast<Eigen::Index>(k);
        sum[column] += value.real();
        sum[static_cast<Eigen::Index>(zernike_moments) + column] += value.imag();
      }
      sums_.row(y * (side + 1) + x + 1) = sum.cast<float>();
    }
  }
}

std::array<double, silhouette_feature_count> SilhouetteFeatures::operator()(std::span<const std::uint8_t> image) const {
  const std::size_t expected = static_cast<std::size_t>(pixels_) * static_cast<std::size_t>(pixels_);
  if (image.size() != expected) {
    throw ArgumentError("a silhouette has " + std::to_string(image.size()) + " pixels; expected " +
                        std::to_string(expected));
  }
  const std::vector<Run> runs = runs_of(image, pixels_);
  Eigen::Matrix<float, 1, 2 * zernike_moments> moments = Eigen::Matrix<float, 1, 2 * zernike_moments>::Zero();
  for (const Run& run : runs) {
    const Eigen::Index row = static_cast<Eigen::Index>(run.row) * (pixels_ + 1);
    moments += sums_.row(row + run.end) - sums_.row(row + run.first);
  }
  std::array<double, silhouette_feature_count> features{};
  for (std::size_t k = 0; k < zernike_moments; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    features[k] = std::hypot(moments[column], moments[static_cast<Eigen::Index>(zernike_moments) + column]);
  }
  const std::vector<Pixel> outline = Outliner(image, pixels_).longest(runs);
  if (outline.size() < 2) return features;
  constexpr std::size_t samples = 128;
  const std::vector<double> distances = distances_along(outline, samples);
  std::array<std::complex<double>, outline_coefficients + 1> coefficients{};
  std::array<std::complex<double>, samples> roots{};
  for (std::size_t i = 0; i < samples; ++i) {
    roots[i] = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(i) / samples);
  }
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t k = 0; k < coefficients.size(); ++k) coefficients[k] += distances[i] * roots[i * k % samples];
  }
  for (std::size_t k = 0; k < outline_coefficients; ++k) {
    features[zernike_moments + k] = std::abs(coefficients[k + 1]) / std::abs(coefficients[0]);
  }
  return features;
}

std::shared_ptr<const SilhouetteFeatures> shared_silhouette_features(int pixels) {
  constexpr int max_cached_pixels = 256;  // 18 MB
  if (pixels > max_cached_pixels) return std::make_shared<const SilhouetteFeatures>(pixels);
  static std::mutex mutex;
  static std::map<int, std::shared_ptr<const SilhouetteFeatures>> cached;
  const std::lock_guard lock(mutex);
  std::shared_ptr<const SilhouetteFeatures>& features = cached[pixels];
  if (features == nullptr) features = std::make_shared<const SilhouetteFeatures>(pixels);
  return features;
}

}  // namespace shapegauge
