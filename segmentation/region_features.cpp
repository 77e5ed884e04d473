// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/region_features.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace shapegauge {

namespace {

constexpr double min_area = 1e-9;
constexpr double min_length = 1e-9;
constexpr double min_spread = 1e-6;
constexpr double min_sight = 0.05;
constexpr double default_tilt = -0.3;  ///< where no samples are near each other

/// Form of a region from its second moments.
struct Form {
  double area;
  Eigen::Vector3d position;
  Eigen::Vector3d spread;   ///< standard deviations along the principal axes, ascending
  Eigen::Vector3d normals;  ///< eigenvalues of the mean n n^T, ascending; (0, 0, 1): flat
};

Form form_of(const RegionSum& sum) {
  Form form;
  form.area = std::max(sum.area, min_area);
  form.position = sum.position / form.area;
  const Eigen::Matrix3d covariance = sum.squared_position / form.area - form.position * form.position.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  form.spread = solver.eigenvalues().cwiseMax(min_spread * min_spread).cwiseSqrt();
  solver.computeDirect(sum.squared_normal / form.area, Eigen::EigenvaluesOnly);
  form.normals = solver.eigenvalues().cwiseMax(0);
  return form;
}

double elongation(const Form& form) { return std::log(form.spread[2] / form.spread[1]); }
double flatness(const Form& form) { return std::log(form.spread[1] / form.spread[0]); }

struct Thickness {
  double mean;
  double deviation;
};

Thickness thickness_of(const RegionSum& sum) {
  const double area = std::max(sum.area, min_area);
  const double mean = sum.thickness / area;
  return {mean, std::sqrt(std::max(0.0, sum.squared_thickness / area - mean * mean))};
}

/// Computes the earth mover's distance between two thickness distributions, in logarithms of thickness.
double earth_movers_distance(const RegionSum& a, const RegionSum& b) {
  double moved = 0;
  double carried = 0;
  for (Eigen::Index k = 0; k < thickness_bins; ++k) {
    carried += a.histogram[k] / std::max(a.area, min_area) - b.histogram[k] / std::max(b.area, min_area);
    moved += std::abs(carried);
  }
  return moved * -std::log(min_histogram_thickness) / thickness_bins;
}

/// Features in order, each with its name.
class Features {
 public:
  Features(const Regions& regions, std::int32_t a, std::int32_t b) : regions_(regions), small_(a), large_(b) {
    if (regions.of(a).area > regions.of(b).area) std::swap(small_, large_);
    add_sights();
    add_thickness();
    add_border();
    add_opposites();
    add_form();
  }

  RegionFeatures values;
  std::array<std::string_view, region_features> names;

 private:
  void add(std::string_view name, double value) {
    names[next_] = name;
    values[static_cast<Eigen::Index>(next_++)] = std::isfinite(value) ? value : 0;
  }

  [[nodiscard]] double between(PairSum what) const { return regions_.of(small_, large_, what); }

  [[nodiscard]] double share(std::int32_t a, std::int32_t b, PairSum what) const {
    const double pairs = regions_.of(a, b, PairSum::pairs);
    return pairs > 0 ? regions_.of(a, b, what) / pairs : 1;
  }

  void add_sights() {
    const auto min_within = [&](PairSum what) {
      return std::min(share(small_, small_, what), share(large_, large_, what));
    };
    const double shallow = share(small_, large_, PairSum::seen_shallow);
    const double deep = share(small_, large_, PairSum::seen_deep);
    const double within_shallow = min_within(PairSum::seen_shallow);
    const double within_deep = min_within(PairSum::seen_deep);
    add("seen shallow", shallow);
    add("seen deep", deep);
    add("own seen shallow", within_shallow);
    add("own seen deep", within_deep);
    add("seen shallow / own", shallow / std::max(min_sight, within_shallow));
    add("seen deep / own", deep / std::max(min_sight, within_deep));
    add("seen outside", share(small_, large_, PairSum::seen_outside));
    add("small seen outside", share(small_, small_, PairSum::seen_outside));
    add("large seen outside", share(large_, large_, PairSum::seen_outside));
  }

  void add_thickness() {
    const Thickness small = thickness_of(regions_.of(small_));
    const Thickness large = thickness_of(regions_.of(large_));
    const double border = between(PairSum::thickness) / std::max(between(PairSum::border), min_length);
    add("thickness apart", std::abs(small.mean - large.mean));
    add("thickness small - large", small.mean - large.mean);
    add("thickness moved", earth_movers_distance(regions_.of(small_), regions_.of(large_)));
    add("thickness spread", std::max(small.deviation, large.deviation));
    add("thickness small", small.mean);
    add("thickness / size small", small.mean - std::log(std::max(regions_.of(small_).area, min_area)) / 2);
    add("thickness / size large", large.mean - std::log(std::max(regions_.of(large_).area, min_area)) / 2);
    add("border thickness - least", border - std::min(small.mean, large.mean));
    add("border thickness - most", border - std::max(small.mean, large.mean));
    add("border / girth",
        std::log(std::max(between(PairSum::border), min_length) / (std::numbers::pi * std::exp(border))));
  }

  void add_border() {
    const double length = std::max(between(PairSum::border), min_length);
    const double area = std::max(regions_.of(small_).area, min_area);
    const double small_perimeter = std::max(regions_.perimeter(small_), min_length);
    const double large_perimeter = std::max(regions_.perimeter(large_), min_length);
    add("border concave", between(PairSum::concave) / length);
    add("border convex", between(PairSum::convex) / length);
    add("border folded", between(PairSum::folded) / length);
    add("tilt near", tilt(PairSum::near_pairs, PairSum::near_tilt));
    add("tilt wide", tilt(PairSum::wide_pairs, PairSum::wide_tilt));
    add("border / size", std::log(length / std::sqrt(area)));
    add("border / least perimeter", length / std::min(small_perimeter, large_perimeter));
    add("border / most perimeter", length / std::max(small_perimeter, large_perimeter));
  }

  [[nodiscard]] double tilt(PairSum pairs, PairSum what) const {
    return between(pairs) > 0 ? between(what) / between(pairs) : default_tilt;
  }

  void add_opposites() {
    const double small = std::max(regions_.of(small_).area, min_area);
    const double large = std::max(regions_.of(large_).area, min_area);
    const double within_small = regions_.of(small_, small_, PairSum::opposite);
    const double within_large = regions_.of(large_, large_, PairSum::opposite);
    add("opposite", between(PairSum::opposite) / small);
    add("own opposite small", within_small / small);
    add("own opposite large", within_large / large);
    add("own opposite both", (within_small + within_large + 2 * between(PairSum::opposite)) / (small + large));
  }

  void add_form() {
    const Form small = form_of(regions_.of(small_));
    const Form large = form_of(regions_.of(large_));
    RegionSum sum = regions_.of(small_);
    sum += regions_.of(large_);
    const Form both = form_of(sum);
    add("elongation small", elongation(small));
    add("elongation large", elongation(large));
    add("elongation both", elongation(both));
    add("flatness small", flatness(small));
    add("flatness large", flatness(large));
    add("flatness both", flatness(both));
    add("one normal small", small.normals[2]);
    add("one normal large", large.normals[2]);
    add("one normal both", both.normals[2]);
    add("distance", (small.position - large.position).norm());
    add("area small", std::log(small.area));
    add("area large", std::log(large.area));
    add("regions", std::log(static_cast<double>(regions_.size())));
  }

  const Regions& regions_;
  std::int32_t small_;
  std::int32_t large_;
  std::size_t next_ = 0;
};

}  // namespace

const std::array<std::string_view, region_features>& region_feature_names() {
  static const std::array<std::string_view, region_features> names = Features(Regions(2), 0, 1).names;
  return names;
}

RegionFeatures features_of(const Regions& regions, std::int32_t a, std::int32_t b) {
  return Features(regions, a, b).values;
}

}  // namespace shapegauge
