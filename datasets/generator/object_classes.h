#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/datasets/generator/solid.h"

namespace shapegauge {

/// A class of rigid objects: hollow, flat, turned or built of pieces, which articulated bodies are not.
struct ObjectClass {
  std::string name;
  std::vector<std::string> parts;  ///< by label; not every object has them all
  SolidObject (*draw)(RandomNumbers& random);
};

/// The classes of objects. Those that differ most come first.
std::span<const ObjectClass> object_classes();

}  // namespace shapegauge
