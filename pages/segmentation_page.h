// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

/// Picture of a segmented shape with its caption.
struct SegmentationPicture {
  std::string_view png;  ///< bytes of a PNG file
  std::string caption;   ///< text below the picture
};

/// Shape on the page of a segmentation experiment: pictures of its parts in a reference segmentation, if there is one,
/// and by each method.
struct SegmentationFigure {
  std::string title;
  std::vector<SegmentationPicture> pictures;  ///< one picture per segmentation of the shape
  std::string_view view = {};                 ///< interactive view as JSON (shape_view_json()); empty for none
};

/// Errors of segmentation methods relative to reference segmentations.
struct SegmentationPageErrors {
  std::string triangle_weights;               ///< how triangles are weighted: "by area" or "equally"
  std::vector<TextTable> tables;              ///< tables of errors, shown in order
  std::vector<std::string> methods;           ///< names of the methods
  std::vector<std::vector<double>> by_class;  ///< mean Rand errors: by_class[class][method]; NaN if undefined
};

/// Contents of the report of a segmentation experiment. The data of its pictures and views must outlive it.
struct SegmentationPage {
  std::string title;
  std::string description;
  std::vector<std::string> classes;              ///< names of the classes
  std::vector<int> labels;                       ///< index in `classes` of the class of each shape
  std::optional<SegmentationPageErrors> errors;  ///< errors of the methods; absent without reference segmentations
  TextTable perturbation_effects;  ///< table of Rand errors that perturbations cause; no rows without perturbations
  TextTable consistency;           ///< table of the consistency of parts within classes (consistency_table())
  std::vector<std::pair<std::string, std::string>> failures;  ///< ids of omitted shapes and the reasons
  std::vector<SegmentationFigure> shown;  ///< figures of all shapes, largest errors first; empty without pictures
  std::vector<std::size_t> typical;       ///< shape of median error of each class, as an index into `shown`
};

/// Renders the report as one self-contained HTML file: tables, bars by class, each shape's parts next to a reference
/// segmentation, and interactive views.
std::string segmentation_page(const SegmentationPage& page);

}  // namespace shapegauge
