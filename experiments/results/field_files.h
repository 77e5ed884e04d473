// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// Writes the values of a field at the samples of a shape to a file atomically.
using FieldFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Eigen::VectorXd& values)>;

/// Names, camera and colours of a file with the values of a field.
struct FieldPicture {
  RenderOptions render = {};
  bool upright = true;                   ///< upright_view() instead of `render`'s direction to the viewer
  bool legend = true;                    ///< colour bar with values next to the shape, if the picture is large enough
  std::string label = "sdf";             ///< heading of the legend: quantity and unit
  std::string value_name = "sdf";        ///< column of .csv files and property of .ply files
  std::optional<Interval> range = {};    ///< of the colours; central_range() if absent
  bool logarithmic = false;              ///< logarithmic colours; the range is then above 0
  std::optional<double> threshold = {};  ///< smaller values have a colour that is not on the map
};

/// Returns the colour scale of a field in the picture. On a logarithmic scale, an automatic range that reaches 0 begins
/// at the smallest positive value.
ColourScale colour_scale_of(const ScalarField& field, const FieldPicture& picture);

/// Returns the writer for the name's extension: .csv (columns index, `value_name`, weight and, at the faces of a mesh
/// whose file has polygons, polygon; shortest numbers that restore the values), .npy (the values, one-dimensional),
/// .ply (the coloured shape, with the values as a property and the colours' range as a comment), .png (a picture).
/// Throws InputError for another extension.
FieldFileWriter field_file_writer(const std::filesystem::path& path, const FieldPicture& picture = {});

/// Writes normals at the samples of a shape to a file atomically.
using NormalFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Points& normals)>;

/// Returns the writer for the name's extension: .csv (columns index,nx,ny,nz,weight and polygon as above), .npy (n x
/// 3), .ply (the shape with normals as properties of its faces or vertices), .xyz (a cloud of the samples, x y z nx ny
/// nz a line). Reading restores the numbers. Throws InputError for another extension.
NormalFileWriter normal_file_writer(const std::filesystem::path& path);

}  // namespace shapegauge
