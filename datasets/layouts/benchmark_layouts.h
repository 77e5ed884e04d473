// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "shapegauge/datasets/layouts/dataset.h"

namespace shapegauge {

/// Layouts of published data sets (docs/manual/datasets.md). The functions find_* throw InputError as find_dataset()
/// does; looks_like_* return true if the names in a folder match the layout.

/// Layout "shrec07": models 1.off to 400.off, twenty consecutive ones per class. Classes with missing models are kept;
/// larger numbers are an error.
/// @{
Dataset find_shrec07_dataset(const DatasetLocation& location);
bool looks_like_shrec07(const std::filesystem::path& root);
/// @}

/// Layout "psb" of the Princeton Shape Benchmark: model 812 is db/8/m812/m812.off, and a .cla file lists the models and
/// their classes. A model without a file gets the expected file name.
/// @{
Dataset find_psb_dataset(const DatasetLocation& location);
bool looks_like_psb(const std::filesystem::path& root);
/// @}

/// Layout "named": file names consist of a class and a number, such as cat0.off, cat10.off and dog1.off.
/// @{
Dataset find_named_dataset(const DatasetLocation& location);
bool looks_like_named(const std::filesystem::path& root);
/// @}

/// Layout "tree": nested folders; each folder with models is a class, named by its path below the root.
/// @{
Dataset find_tree_dataset(const DatasetLocation& location);
bool looks_like_tree(const std::filesystem::path& root);
/// @}

/// Layout "shapenet" of ShapeNetCore as used in SHREC'16 and '17: a table id,synsetId,subSynsetId,modelId,split. A
/// model of the split s is `s/model_ID.obj`, possibly within a folder of its synset; its class is its synset.
/// @{
Dataset find_shapenet_dataset(const DatasetLocation& location);
bool looks_like_shapenet(const std::filesystem::path& root);
/// @}

}  // namespace shapegauge
