#pragma once

#include "shapegauge/experiments/generator/skeleton.h"

namespace shapegauge {

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
