// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/datasets/layouts/layouts.h"

namespace shapegauge {

// Layouts of published data sets (docs/manual/datasets.md), recognised by the names in a folder.

/// Returns the layout "shrec07": models 1.off to 400.off, twenty consecutive ones per class. Classes with missing
/// models are kept; larger numbers are an error.
DatasetLayout shrec07_layout();

/// Returns the layout "psb" of the Princeton Shape Benchmark: model 812 is db/8/m812/m812.off, and a .cla file lists
/// the models and their classes. A model without a file gets the expected file name.
DatasetLayout psb_layout();

/// Returns the layout "named": file names consist of a class and a number, such as cat0.off, cat10.off and dog1.off.
DatasetLayout named_layout();

/// Returns the layout "tree": nested folders; each folder with models is a class, named by its path below the root.
DatasetLayout tree_layout();

/// Returns the layout "shapenet" of ShapeNetCore as used in SHREC'16 and '17, with a table
/// id,synsetId,subSynsetId,modelId,split. A model of the split s is `s/model_ID.obj`, possibly within a folder of its
/// synset; its class is its synset.
DatasetLayout shapenet_layout();

}  // namespace shapegauge
