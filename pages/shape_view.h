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

/// Returns the range of values without the thinnest 2 % and the thickest 2 % of the area. Outliers, such as a few rays
/// along a limb, would otherwise dominate the colour scale. Nothing if all values are missing.
std::optional<Interval> central_range(const ScalarField& field);

/// Colour of a shape without values.
inline constexpr Colour plain_colour = {198, 198, 194};

/// Field in a view.
struct ViewField {
  std::string name;
  Eigen::VectorXd values;    ///< one an element; NaN if missing
  Interval colours;          ///< values at the ends of the colour scale
  bool set_range = false;    ///< the scale was requested and applies to each shape; otherwise shapes may share one
  bool logarithmic = false;  ///< logarithmic colours; the scale begins above 0
  std::optional<double> threshold = {};  ///< smaller values are red (below_threshold)
  std::string_view measured_by = {};     ///< measured_by() of its type
  double unit = 1;                       ///< length of the value 1
};

/// Returns what the values of a type of field are lengths of, which a view draws where a reader points: "ray", "ball"
/// (a diameter), "gap" (that of a ball outside), or nothing.
std::string_view measured_by(std::string_view field_type);

/// Listed region of a shape. A click turns the view there.
struct ViewRegion {
  std::string text;
  Eigen::Vector3d position;
  Eigen::Vector3d towards_viewer;  ///< direction from which it is shown
  double size = 0;                 ///< of what is shown around the position
};

/// Parts in a view.
struct ViewParts {
  std::string name;
  std::vector<std::int32_t> labels;  ///< one per element
  std::vector<Colour> colours;       ///< per part
};

/// Interactive 3D view of a shape with its colourings. Its elements are faces or vertices, or the points of a cloud.
struct ShapeView {
  std::string name;
  std::string note = {};  ///< text after the name; may be empty
  Shape shape;
  SampleSite site = SampleSite::faces;  ///< faces or vertices; vertices for a cloud
  std::vector<ViewField> fields = {};
  std::vector<ViewParts> parts = {};  ///< per segmentation
  Points normals = {};                ///< unit or zero, one an element, or empty
  Eigen::Vector3d up = {0, 0, 1};     ///< vertical direction of the initial position, which is upright_view()
  std::vector<ViewRegion> regions = {};
};

/// Encodes the view for the page's scripts (pages/view/shape_data.mjs): coordinates in 65,536 steps of the longest side
/// of the box, values in 65,535 steps from minimum to maximum, without unused vertices. The initial position is
/// upright_view(). Throws InputError for a shape without extent.
nlohmann::ordered_json shape_view_json(const ShapeView& view);

/// Renders a square picture of the view in its initial position, coloured by its first field, as PNG bytes with a
/// transparent background. For readers without WebGL. Throws as render_shape() does.
std::string shape_view_picture(const ShapeView& view, int pixels);

/// Page of `shapegauge view`.
struct ViewPage {
  std::string title;
  std::vector<ShapeView> shapes;     ///< at least one
  std::vector<std::string> missing;  ///< names of unusable shapes
  std::vector<std::string> warnings = {};
  std::string unit = {};  ///< of lengths; empty if unknown
};

/// Renders the page as one self-contained HTML file. The same shapes give the same bytes on any number of threads.
/// Throws as shape_view_json() and shape_view_picture() do.
std::string view_page(const ViewPage& page);

}  // namespace shapegauge
