// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// Returns the range of a field's values from the 2nd to the 98th percentile by area. Outliers, such as a few rays
/// along a limb, would otherwise dominate the colour scale. Nothing if all values are missing.
std::optional<Interval> central_range(const ScalarField& field);

/// Colour of a shape that no field colours.
inline constexpr Colour plain_colour = {198, 198, 194};

/// Scalar field in a view: its values and their mapping to colours.
struct ViewField {
  std::string name;
  Eigen::VectorXd values;    ///< value of each face, vertex or point; NaN if missing
  Interval colours;          ///< values at the ends of the colour scale
  bool set_range = false;    ///< true if `colours` is fixed; false if it may be widened to a scale common to all shapes
  bool logarithmic = false;  ///< true for a logarithmic colour scale, which begins above 0
  std::optional<double> threshold = {};  ///< values below it are red (below_threshold); absent for none
  std::string_view measured_by = {};     ///< measured object: "ray", "ball" or "gap", see measured_by(); empty for none
  double unit = 1;                       ///< length that the value 1 represents, in coordinate units
};

/// Returns the object that a field of this type measures: "ray" (its length), "ball" (its diameter), "gap" (diameter of
/// a ball outside the shape), or "" for other fields. A view draws the object at the pointer.
std::string_view measured_by(std::string_view field_type);

/// Region of a shape in the list next to a view. A click on its text turns the view towards the region.
struct ViewRegion {
  std::string text;                ///< text of the region in the list
  Eigen::Vector3d position;        ///< point of the region at the centre of the view, in the shape's coordinates
  Eigen::Vector3d towards_viewer;  ///< direction from the region to the viewer
  double size = 0;                 ///< length that is visible around the position, in coordinate units
};

/// Segmentation in a view: part labels and colours.
struct ViewParts {
  std::string name;
  std::vector<std::int32_t> labels;  ///< part label of each face, vertex or point
  std::vector<Colour> colours;       ///< colour of each part, indexed by label
};

/// Interactive 3D view of a shape with its colourings. Its elements are faces or vertices, or the points of a cloud.
struct ShapeView {
  std::string name;
  std::string note = {};                 ///< text shown after the name; empty for none
  Shape shape;                           ///< mesh or point cloud
  SampleSite site = SampleSite::faces;   ///< elements with values: faces or vertices; vertices for a cloud
  std::vector<ViewField> fields = {};    ///< scalar fields, from which the reader chooses
  std::vector<ViewParts> parts = {};     ///< segmentations, from which the reader chooses
  Points normals = {};                   ///< unit or zero normal of each face, vertex or point; empty for none
  Eigen::Vector3d up = {0, 0, 1};        ///< vertical direction of the shape in the initial view (upright_view())
  std::vector<ViewRegion> regions = {};  ///< regions listed next to the view
};

/// Encodes the view for the page's scripts (pages/view/shape_data.mjs): coordinates in 65,536 steps of the longest side
/// of the bounding box, values in 65,535 steps from minimum to maximum, without unused vertices. The initial position
/// is upright_view(). Throws InputError for a shape without extent.
nlohmann::ordered_json shape_view_json(const ShapeView& view);

/// Renders a square picture of the view in its initial position, coloured by its first field, as PNG bytes with a
/// transparent background. For readers without WebGL. Throws as render_shape() does.
std::string shape_view_picture(const ShapeView& view, int pixels);

/// Contents of the page of `shapegauge view`.
struct ViewPage {
  std::string title;
  std::vector<ShapeView> shapes;           ///< views of the shapes, at least one
  std::vector<std::string> missing;        ///< names of unusable shapes
  std::vector<std::string> warnings = {};  ///< warnings shown on the page
  std::string unit = {};                   ///< unit of lengths; empty if unknown
};

/// Renders the page as one self-contained HTML file. The same shapes give the same bytes on any number of threads.
/// Throws as shape_view_json() and shape_view_picture() do.
std::string view_page(const ViewPage& page);

}  // namespace shapegauge
