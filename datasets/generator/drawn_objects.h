// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/datasets/generator/solid.h"

namespace shapegauge {

/// Draws random numbers for the properties of an object.
class Draw {
 public:
  explicit Draw(RandomNumbers& random) : random_(random) {}

  double operator()(double low, double high) { return random_.uniform(low, high); }  ///< random number in [low, high)
  bool happens(double probability) { return random_.uniform(0, 1) < probability; }   ///< true with this probability
  /// Returns an integer uniform in [low, high].
  int from(int low, int high) {
    return low + static_cast<int>(random_.below(static_cast<std::uint64_t>(high - low) + 1));
  }

 private:
  RandomNumbers& random_;  ///< source of random numbers
};

/// Makes a straight leg or post of square or round cross-section; `radius` is half its thickness.
Solid post(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, bool square);

/// Draw a random object of a class, about 2 units in size, with z up; not part of the public interface.
/// @{
SolidObject draw_aeroplane(RandomNumbers& random);
SolidObject draw_bracket(RandomNumbers& random);
SolidObject draw_bust(RandomNumbers& random);
SolidObject draw_chair(RandomNumbers& random);
SolidObject draw_fish(RandomNumbers& random);
SolidObject draw_hammer(RandomNumbers& random);
SolidObject draw_mug(RandomNumbers& random);
SolidObject draw_shaft(RandomNumbers& random);
SolidObject draw_spectacles(RandomNumbers& random);
SolidObject draw_table(RandomNumbers& random);
SolidObject draw_teapot(RandomNumbers& random);
SolidObject draw_vase(RandomNumbers& random);
/// @}

}  // namespace shapegauge
