// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/datasets/files/random_matrices.h"

#include <cmath>
#include <limits>
#include <random>

namespace shapegauge {

rc::Gen<DistanceMatrix> square_matrices() {
  return rc::gen::apply(
      [](Eigen::Index size, unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> mantissa(-1, 1);
        std::uniform_int_distribution<int> exponent(-120, 121);
        return DistanceMatrix(DistanceMatrix::NullaryExpr(size, size, [&] {
          const int power = exponent(random);
          if (power == 121) return std::numeric_limits<double>::infinity();
          return static_cast<double>(std::ldexp(mantissa(random), power));
        }));
      },
      rc::gen::inRange<Eigen::Index>(1, 13), rc::gen::arbitrary<unsigned>());
}

}  // namespace shapegauge
