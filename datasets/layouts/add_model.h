#pragma once

#include <set>
#include <string>

#include "shapegauge/datasets/layouts/dataset.h"

/// Code shared by the layouts; not part of the public interface.
namespace shapegauge {

/// Returns the label of a class, adding it if the name is new.
int label_of_class(const std::string& name, Dataset& dataset);

/// Adds a model. `ids` are those of the models so far. Throws InputError, with the file, for a repeated id.
void add_model(Model model, std::set<std::string>& ids, Dataset& dataset);

}  // namespace shapegauge
