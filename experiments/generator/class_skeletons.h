#pragma once

#include <cstddef>

#include "shapegauge/experiments/generator/skeleton.h"

namespace shapegauge {

/// Number of classes.
std::size_t class_count();

/// The skeleton of a class, from 0 to class_count() - 1. Those that differ most come first.
Skeleton class_skeleton(std::size_t index);

// The classes: each a skeleton in its rest pose, of about the size of 2 to 4 units, in a file of its own.

Skeleton ant();
Skeleton bird();
Skeleton crab();
Skeleton dinosaur();
Skeleton dog();
Skeleton flamingo();
Skeleton glasses();
Skeleton hand();
Skeleton horse();
Skeleton human();
Skeleton lamp();
Skeleton octopus();
Skeleton pliers();
Skeleton shark();
Skeleton snake();
Skeleton spider();

}  // namespace shapegauge
