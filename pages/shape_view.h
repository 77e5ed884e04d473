#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// The values between which all but the thinnest 2 % and the thickest 2 % of the area lie: a few rays along a limb
/// would otherwise use up a scale of colours. Nothing where no value is known.
std::optional<Interval> central_range(const ScalarField& field);

/// The colour of a shape without values.
inline constexpr Colour plain_colour = {198, 198, 194};

/// A field in a view.
struct ViewField {
  std::string name;
  Eigen::VectorXd values;    ///< one a place; NaN where there is none
  Interval colours;          ///< the values with the ends of the colour scale
  bool set_range = false;    ///< the scale was asked for, and holds for each shape; else shapes may share one
  bool logarithmic = false;  ///< colours by the logarithm; the scale begins above 0
  std::optional<double> threshold = {};  ///< what is less is painted red (below_threshold)
};

/// A shape that a page lets its reader turn, and what its colours can show. Its places are faces or vertices, of a
/// cloud its points.
struct ShapeView {
  std::string name;
  std::string note = {};  ///< said behind the name; may be empty
  Shape shape;
  SampleSite site = SampleSite::faces;  ///< faces or vertices; of a cloud vertices
  std::vector<ViewField> fields = {};
  std::vector<std::int32_t> parts = {};    ///< one a place, or none at all
  std::vector<Colour> part_colours = {};   ///< by part
  Points normals = {};                     ///< unit or zero, one a place, or none at all
  std::optional<Eigen::Vector3d> up = {};  ///< upright in the first position; none: that of principal_view()
};

/// The view as the data that the page's scripts read (pages/view/shape_data.mjs): coordinates in 65,536 steps
/// of the longest side of the box, values in 65,535 steps from the least to the largest, vertices that no triangle uses
/// left out. The first position is principal_view(), or from the front and a little above where the view says what is
/// up. Throws InputError where the shape has no extent.
nlohmann::ordered_json shape_view_json(const ShapeView& view);

/// A square picture of the view in its first position, coloured by its first field, as the bytes of a PNG file with a
/// transparent background: for who has no WebGL. Throws as render_shape().
std::string shape_view_picture(const ShapeView& view, int pixels);

/// The page of `shapegauge view`.
struct ViewPage {
  std::string title;
  std::vector<ShapeView> shapes;     ///< at least one
  std::vector<std::string> missing;  ///< names of shapes that could not be used
  std::vector<std::string> warnings = {};
  std::string unit = {};  ///< of lengths; empty: not known
};

/// The page as one HTML file that needs nothing else. The same shapes give the same bytes, on any number of threads.
/// Throws as the two functions above.
std::string view_page(const ViewPage& page);

}  // namespace shapegauge
