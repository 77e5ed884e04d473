#pragma once

#include <filesystem>

#include "shapegauge/datasets/layouts/dataset.h"

namespace shapegauge {

/// Layouts in which published data sets come (docs/manual/datasets.md). find_* throw InputError as find_dataset();
/// looks_like_* say whether a folder has the layout, from the names in it.

/// The layout "shrec07": models 1.off to 400.off, twenty of each class in a row. A class that lacks models stays, and
/// further numbers are an error.
/// @{
Dataset find_shrec07_dataset(const DatasetLocation& location);
bool looks_like_shrec07(const std::filesystem::path& root);
/// @}

/// The layout "psb" of the Princeton Shape Benchmark: model 812 is db/8/m812/m812.off, and a .cla file says which
/// models are used and their classes. A model without a file gets the name that the file should have.
/// @{
Dataset find_psb_dataset(const DatasetLocation& location);
bool looks_like_psb(const std::filesystem::path& root);
/// @}

/// The layout "named": files whose names are a class and a number, such as cat0.off, cat10.off and dog1.off.
/// @{
Dataset find_named_dataset(const DatasetLocation& location);
bool looks_like_named(const std::filesystem::path& root);
/// @}

/// The layout "tree": folders in folders; each folder that holds models is a class, named by its path below the root.
/// @{
Dataset find_tree_dataset(const DatasetLocation& location);
bool looks_like_tree(const std::filesystem::path& root);
/// @}

/// The layout "shapenet" of ShapeNetCore as SHREC'16 and '17 had it: a table id,synsetId,subSynsetId,modelId,split; a
/// model of the split s is s/model_<id>.obj, or below a folder of its synset there; its class is its synset.
/// @{
Dataset find_shapenet_dataset(const DatasetLocation& location);
bool looks_like_shapenet(const std::filesystem::path& root);
/// @}

}  // namespace shapegauge
