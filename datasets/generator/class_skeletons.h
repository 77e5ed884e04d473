#pragma once

#include <cstddef>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Number of classes.
std::size_t class_count();

/// The skeleton of a class, from 0 to class_count() - 1. Those that differ most come first.
Skeleton class_skeleton(std::size_t index);

}  // namespace shapegauge
