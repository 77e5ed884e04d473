#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

/// A picture and its caption.
struct SegmentationPicture {
  std::string_view png;  ///< the bytes of a PNG file
  std::string caption;
};

/// A shape on the page: its parts as a person sees them, where somebody does, and by each method.
struct SegmentationFigure {
  std::string title;
  std::vector<SegmentationPicture> pictures;
};

/// Mean Rand errors of a class.
struct SegmentationClassErrors {
  std::string name;
  std::vector<double> errors;  ///< by method; NaN where none is defined
};

/// Errors against people's segmentations.
struct SegmentationPageErrors {
  std::string triangle_weights;  ///< how much a triangle counts, in words
  std::vector<Table> tables;
  std::vector<std::string> methods;
  std::vector<SegmentationClassErrors> classes;
  Table class_table;
};

/// All that the report of a segmentation experiment shows. What its pictures point to must outlive it.
struct SegmentationPage {
  std::string title;
  std::string description;
  std::size_t shapes = 0;
  std::size_t classes = 0;
  std::optional<SegmentationPageErrors> errors;               ///< none: nobody has segmented the shapes
  Table moved;                                                ///< errors under perturbations; no rows: there are none
  Table consistency;                                          ///< of the parts among the shapes of a class
  std::vector<std::pair<std::string, std::string>> failures;  ///< shapes left out, and why
  std::vector<SegmentationFigure> typical;                    ///< one shape of each class
  std::vector<SegmentationFigure> shown;  ///< all shapes, those of the greatest errors first; none without pictures
};

/// The report as one HTML file without scripts: tables, bars by class, and each shape's parts beside a person's.
std::string segmentation_page(const SegmentationPage& page);

}  // namespace shapegauge
