#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/segmentation/boundary_smoothing.h"
#include "shapegauge/segmentation/part_model.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// To be raised with every change of part_segmentation() that changes a label: what a cache holds of earlier versions
/// is then computed anew.
inline constexpr int part_segmentation_version = 4;

/// How a shape is cut into parts.
struct PartSegmentationOptions {
  int parts = 0;                   ///< wanted, at least 0; 0: as many as there are
  int patches = 150;               ///< that the surface is cut into first, at least 1; more where more parts are wanted
  int samples = 1000;              ///< of the surface that look for each other, at least 1
  double least_probability = 0.5;  ///< of two regions to be one part, below which they stay apart; 0 to 1
  BoundarySmoothingOptions smoothing{};
  std::uint64_t seed = 1;
};

/// Cuts a shape into parts as people would: for each triangle, or point of a cloud, the number of its part, from 0 on
/// in the order of the parts' first triangles.
///
/// A mesh of few triangles or with many cracks is cut by its stand_in(). The surface is cut into patches; patches are
/// merged into regions, always the two that most probably belong to one part, as the model says from what the regions
/// see of each other, how thick the shape is in each, how concave the surface is between them and how they are formed;
/// at last borders are smoothed. Parts are connected but for what smoothing cuts off. Components of the shape that do
/// not touch are different parts, so that there may be more than were wanted. The same input gives the same labels on
/// any number of threads.
///
/// Throws InputError for options out of range, more parts than triangles or points, and as thick_surface().
std::vector<std::int32_t> part_segmentation(const Shape& shape, const PartSegmentationOptions& options,
                                            const PartModel& model = trained_part_model());

/// The same for a surface whose thickness is known.
std::vector<std::int32_t> part_segmentation(const ThickSurface& surface, const PartSegmentationOptions& options,
                                            const PartModel& model = trained_part_model());

}  // namespace shapegauge
