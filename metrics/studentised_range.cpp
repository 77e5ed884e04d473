// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/studentised_range.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

void check_count(std::size_t count) {
  if (count < 2) throw ArgumentError("the studentised range needs at least two groups, not " + std::to_string(count));
}

}  // namespace

double studentised_range_probability(double range, std::size_t count) {
  check_count(count);
  if (std::isnan(range)) throw ArgumentError("the studentised range is NaN");
  if (range <= 0) return 0;
  if (std::isinf(range)) return 1;
  // The smallest value is z; the others are between z and z + range.
  const boost::math::normal normal;
  const auto density = [&](double z) {
    const double between = boost::math::cdf(normal, z + range) - boost::math::cdf(normal, z);
    return boost::math::pdf(normal, z) * std::pow(between, static_cast<double>(count - 1));
  };
  constexpr double tail = 9;  // beyond it the density is below 1e-18
  const double integral =
      boost::math::quadrature::gauss_kronrod<double, 61>::integrate(density, -tail, tail, 15, 1e-13);
  return std::min(1.0, static_cast<double>(count) * integral);
}

double studentised_range_quantile(double alpha, std::size_t count) {
  check_count(count);
  if (!(alpha > 0 && alpha < 1)) {
    throw ArgumentError("the significance level is " + std::to_string(alpha) + "; it must be between 0 and 1");
  }
  const auto excess = [&](double range) { return studentised_range_probability(range, count) - (1 - alpha); };
  double high = 4;
  constexpr double most = 64;  // exceeded with a probability that is 0 in double precision
  while (excess(high) < 0 && high < most) high *= 2;
  std::uintmax_t steps = 200;
  const auto [below, above] =
      boost::math::tools::toms748_solve(excess, 0.0, high, boost::math::tools::eps_tolerance<double>(45), steps);
  return (below + above) / 2;
}

}  // namespace shapegauge
