#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

/// Picture with its caption.
struct SegmentationPicture {
  std::string_view png;  ///< the bytes of a PNG file
  std::string caption;
};

/// Shape on the page: its parts in a human segmentation, if there is one, and by each method.
struct SegmentationFigure {
  std::string title;
  std::vector<SegmentationPicture> pictures;
};

/// Mean Rand errors of a class.
struct SegmentationClassErrors {
  std::string name;
  std::vector<double> errors;  ///< per method; NaN if undefined
};

/// Errors relative to human segmentations.
struct SegmentationPageErrors {
  std::string triangle_weights;  ///< weighting of triangles, in words
  std::vector<TextTable> tables;
  std::vector<std::string> methods;
  std::vector<SegmentationClassErrors> classes;
  TextTable class_table;
};

/// Contents of the report of a segmentation experiment. The data of its pictures must outlive it.
struct SegmentationPage {
  std::string title;
  std::string description;
  std::size_t shapes = 0;
  std::size_t classes = 0;
  std::optional<SegmentationPageErrors> errors;               ///< absent without human segmentations
  TextTable moved;                                            ///< errors under perturbations; no rows without any
  TextTable consistency;                                      ///< consistency of parts among the shapes of a class
  std::vector<std::pair<std::string, std::string>> failures;  ///< omitted shapes and the reasons
  std::vector<SegmentationFigure> typical;                    ///< one shape per class
  std::vector<SegmentationFigure> shown;  ///< all shapes, largest errors first; empty without pictures
};

/// Renders the report as one HTML file without scripts: tables, bars by class, and each shape's parts beside a human
/// segmentation.
std::string segmentation_page(const SegmentationPage& page);

}  // namespace shapegauge
