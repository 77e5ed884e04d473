#pragma once

#include <cstddef>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Number of classes.
std::size_t class_count();

/// The skeleton of a class, from 0 to class_count() - 1. Those that differ most come first.
Skeleton class_skeleton(std::size_t index);

/// The classes, each a skeleton in its rest pose, of about the size of 2 to 4 units.
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
