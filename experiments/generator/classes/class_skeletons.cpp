#include "shapegauge/experiments/generator/classes/class_skeletons.h"

#include <array>

namespace shapegauge {

namespace {

// A class's place also seeds its models: append, do not reorder.
constexpr std::array skeletons = {&dog,    &human, &hand,  &octopus, &spider,   &bird,     &snake, &glasses,
                                  &pliers, &ant,   &shark, &lamp,    &dinosaur, &flamingo, &crab,  &horse};

}  // namespace

std::size_t class_count() { return skeletons.size(); }

Skeleton class_skeleton(std::size_t index) { return skeletons.at(index)(); }

}  // namespace shapegauge
