// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/datasets/generator/solid.h"

namespace shapegauge {

/// Class of rigid objects: hollow, flat, lathed or composed of pieces, unlike articulated bodies.
struct ObjectClass {
  std::string name;                            ///< name of the class, such as "chair"
  std::vector<std::string> parts;              ///< names of the parts, indexed by label; an object may lack some parts
  SolidObject (*draw)(RandomNumbers& random);  ///< draws a random object of the class
};

/// Returns the classes of rigid objects. The most distinct classes come first.
std::span<const ObjectClass> object_classes();

}  // namespace shapegauge
