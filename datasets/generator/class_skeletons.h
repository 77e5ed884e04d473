// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Returns the number of classes of articulated bodies.
std::size_t articulated_class_count();

/// Returns the skeleton of a class, from 0 to articulated_class_count() - 1. The most distinct classes come first.
Skeleton class_skeleton(std::size_t index);

/// Return the skeletons of the articulated classes in the rest pose, 2 to 4 units in size.
/// @{
Skeleton ant_skeleton();
Skeleton bird_skeleton();
Skeleton crab_skeleton();
Skeleton dinosaur_skeleton();
Skeleton dog_skeleton();
Skeleton flamingo_skeleton();
Skeleton glasses_skeleton();
Skeleton hand_skeleton();
Skeleton horse_skeleton();
Skeleton human_skeleton();
Skeleton lamp_skeleton();
Skeleton octopus_skeleton();
Skeleton pliers_skeleton();
Skeleton shark_skeleton();
Skeleton snake_skeleton();
Skeleton spider_skeleton();
/// @}

}  // namespace shapegauge
