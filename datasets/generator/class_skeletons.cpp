// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/class_skeletons.h"

#include <array>

namespace shapegauge {

namespace {

// The index of a class also seeds its models: append, do not reorder.
constexpr std::array skeletons = {&dog_skeleton,      &human_skeleton,    &hand_skeleton,  &octopus_skeleton,
                                  &spider_skeleton,   &bird_skeleton,     &snake_skeleton, &glasses_skeleton,
                                  &pliers_skeleton,   &ant_skeleton,      &shark_skeleton, &lamp_skeleton,
                                  &dinosaur_skeleton, &flamingo_skeleton, &crab_skeleton,  &horse_skeleton};

}  // namespace

std::size_t articulated_class_count() { return skeletons.size(); }

Skeleton class_skeleton(std::size_t index) { return skeletons.at(index)(); }

}  // namespace shapegauge
