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

/// Options of files with the values of a field: camera, colours and names.
struct FieldPicture {
  RenderOptions render = {};       ///< camera and image size of pictures
  bool upright = true;             ///< true to view the shape by upright_view(), false from the direction in `render`
  bool legend = true;              ///< true for a colour bar with values, if the picture is large enough
  std::string label = "sdf";       ///< heading of the legend: quantity and unit
  std::string value_name = "sdf";  ///< column of .csv files and property of .ply files
  std::optional<Interval> range = {};    ///< values at the ends of the colour map; central_range() if absent
  bool logarithmic = false;              ///< true for a logarithmic colour scale; `range` must then be positive
  std::optional<double> threshold = {};  ///< field values below it are coloured red; absent for none
};

/// Returns the colour scale of the picture of a field. On a logarithmic scale, an automatic range that reaches 0 begins
/// at the smallest positive value.
ColourScale colour_scale_of(const ScalarField& field, const FieldPicture& picture);

/// Returns the writer of field values for the extension of the file's name: .csv (columns index, `value_name`, weight
/// and, at the faces of a mesh whose file has polygons, polygon; shortest numbers that restore the values), .npy (the
/// values, one-dimensional), .ply (the coloured shape, with the values as a property and the colours' range as a
/// comment), .png (a picture). Throws InputError for another extension.
FieldFileWriter field_file_writer(const std::filesystem::path& path, const FieldPicture& picture = {});

/// Writes normals at the samples of a shape to a file atomically.
using NormalFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Points& normals)>;

/// Returns the writer of normals for the extension of the file's name: .csv (columns index,nx,ny,nz,weight and polygon
/// as in field_file_writer()), .npy (n x 3), .ply (the shape with normals as properties of its faces or vertices), .xyz
/// (a cloud of the samples, one line x y z nx ny nz per sample). Reading restores the numbers. Throws InputError for
/// another extension.
NormalFileWriter normal_file_writer(const std::filesystem::path& path);

}  // namespace shapegauge
