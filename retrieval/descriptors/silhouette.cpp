#include "shapegauge/retrieval/descriptors/silhouette.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

/// Twice the signed area of the triangle abc.
double orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// An image to draw in, in pixels.
class Canvas {
 public:
  explicit Canvas(int pixels)
      : pixels_(pixels), image_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), 0) {}

  void draw_point(const Eigen::Vector2d& at) {
    set(std::clamp(static_cast<int>(at.x()), 0, pixels_ - 1), std::clamp(static_cast<int>(at.y()), 0, pixels_ - 1));
  }

  void draw_triangle(const Eigen::Vector2d& a, Eigen::Vector2d b, Eigen::Vector2d c) {
    if (orientation(a, b, c) < 0) std::swap(b, c);
    const auto [left, right] = centres_between(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}));
    const auto [top, bottom] = centres_between(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}));
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const Eigen::Vector2d centre(x + 0.5, y + 0.5);
        if (orientation(a, b, centre) >= 0 && orientation(b, c, centre) >= 0 && orientation(c, a, centre) >= 0) {
          set(x, y);
        }
      }
    }
  }

  std::vector<std::uint8_t> take() { return std::move(image_); }

 private:
  /// The first and the last pixel whose centre lies between two coordinates.
  [[nodiscard]] std::pair<int, int> centres_between(double low, double high) const {
    return {std::max(static_cast<int>(std::ceil(low - 0.5)), 0),
            std::min(static_cast<int>(std::floor(high - 0.5)), pixels_ - 1)};
  }

  void set(int x, int y) {
    image_[static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(x)] = 1;
  }

  int pixels_;
  std::vector<std::uint8_t> image_;
};

constexpr int highest_order = 10;

/// A Zernike polynomial's order and repetition.
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

/// Radial polynomials at many radii: their coefficients are known before.
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

  /// Its value, from the radius' powers.
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

/// A pixel of an image; also a step.
struct Pixel {
  int x;
  int y;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// Follows outlines in a binary image.
class Outliner {
 public:
  Outliner(std::span<const std::uint8_t> image, int pixels) : image_(image), pixels_(pixels), seen_(image.size(), 0) {}

  /// The longest outline of a connected part.
  std::vector<Pixel> longest() {
    std::vector<Pixel> longest;
    for (int y = 0; y < pixels_; ++y) {
      for (int x = 0; x < pixels_; ++x) {
        if (!filled({x, y}) || seen_[index({x, y})] != 0) continue;
        std::vector<Pixel> outline = follow({x, y});
        if (outline.size() > longest.size()) longest = std::move(outline);
        mark_part({x, y});
      }
    }
    return longest;
  }

 private:
  static constexpr std::array<Pixel, 8> around = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

  [[nodiscard]] std::size_t index(Pixel p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(p.x);
  }
  [[nodiscard]] bool filled(Pixel p) const {
    return p.x >= 0 && p.y >= 0 && p.x < pixels_ && p.y < pixels_ && image_[index(p)] != 0;
  }

  /// Moore's neighbour tracing, from a part's first pixel in reading order, until its first step comes again.
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

  void mark_part(Pixel start) {
    std::vector<Pixel> open = {start};
    seen_[index(start)] = 1;
    while (!open.empty()) {
      const Pixel here = open.back();
      open.pop_back();
      for (const Pixel& step : around) {
        const Pixel next{here.x + step.x, here.y + step.y};
        if (!filled(next) || seen_[index(next)] != 0) continue;
        seen_[index(next)] = 1;
        open.push_back(next);
      }
    }
  }

  std::span<const std::uint8_t> image_;
  int pixels_;
  std::vector<char> seen_;
};

/// Distances of a closed outline from its centroid, at so many equal steps along it.
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

std::vector<std::uint8_t> silhouette(const Shape& mesh, const Eigen::Matrix3d& rotation, int pixels) {
  Canvas canvas(pixels);
  const Points rotated = mesh.vertices * rotation.transpose();
  const Eigen::Matrix2Xd seen = ((rotated.leftCols<2>().transpose().array() + 1) / 2 * pixels).matrix();
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector2d a = seen.col(mesh.triangles(f, 0));
    const Eigen::Vector2d b = seen.col(mesh.triangles(f, 1));
    const Eigen::Vector2d c = seen.col(mesh.triangles(f, 2));
    canvas.draw_triangle(a, b, c);
    for (const Eigen::Vector2d& corner : {a, b, c}) canvas.draw_point(corner);
  }
  return canvas.take();
}

SilhouetteFeatures::SilhouetteFeatures(int pixels) : pixels_(pixels) {
  const Eigen::Index side = pixels;
  basis_.setZero(side * side, 2 * zernike_moments);
  const std::array<ZernikeIndex, zernike_moments> indices = zernike_indices();
  const std::vector<RadialPolynomial> radial(indices.begin(), indices.end());
  const double pixel_area = 4.0 / (static_cast<double>(pixels) * pixels);
  for (Eigen::Index y = 0; y < side; ++y) {
    for (Eigen::Index x = 0; x < side; ++x) {
      const std::complex<double> place((2.0 * static_cast<double>(x) + 1) / pixels - 1,
                                       (2.0 * static_cast<double>(y) + 1) / pixels - 1);
      const double radius = std::abs(place);
      if (radius > 1) continue;
      const double angle = std::arg(place);
      std::array<double, highest_order + 1> powers{};
      for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = std::pow(radius, static_cast<int>(k));
      for (std::size_t k = 0; k < zernike_moments; ++k) {
        const double factor = (indices[k].order + 1) / std::numbers::pi * pixel_area;
        const std::complex<double> value = std::polar(factor * radial[k](powers), -indices[k].repetition * angle);
        const auto column = static_cast<Eigen::Index>(k);
        basis_(y * side + x, column) = static_cast<float>(value.real());
        basis_(y * side + x, static_cast<Eigen::Index>(zernike_moments) + column) = static_cast<float>(value.imag());
      }
    }
  }
}

std::array<double, silhouette_feature_count> SilhouetteFeatures::operator()(std::span<const std::uint8_t> image) const {
  if (std::ssize(image) != basis_.rows()) {
    throw ArgumentError("a silhouette of " + std::to_string(image.size()) + " pixels, not " +
                        std::to_string(basis_.rows()));
  }
  Eigen::Matrix<float, 1, 2 * zernike_moments> moments = Eigen::Matrix<float, 1, 2 * zernike_moments>::Zero();
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (image[i] != 0) moments += basis_.row(static_cast<Eigen::Index>(i));
  }
  std::array<double, silhouette_feature_count> features{};
  for (std::size_t k = 0; k < zernike_moments; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    features[k] = std::hypot(moments[column], moments[static_cast<Eigen::Index>(zernike_moments) + column]);
  }
  const std::vector<Pixel> outline = Outliner(image, pixels_).longest();
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

}  // namespace shapegauge
