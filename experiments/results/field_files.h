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

/// Writes the values of a field at the samples of a shape to a file, whole or not at all.
using FieldFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Eigen::VectorXd& values)>;

/// How a picture of a field is taken, and how its values become colours.
struct FieldPicture {
  RenderOptions render = {};
  bool principal = false;  ///< seen along the shape's own axes (principal_view()) instead of from `render`'s direction
  bool legend = true;      ///< the colours with their values beside the shape, where the picture is large enough
  std::string label = "sdf";             ///< heading of the legend: what is measured, and its unit
  std::optional<Interval> range = {};    ///< of the colours; else central_range()
  bool logarithmic = false;              ///< colours by the logarithm; the range is then above 0
  std::optional<double> threshold = {};  ///< what is less is painted in a colour that is not on the map
};

/// The colours of a field in the picture. A range of its own that reaches 0 begins, on a logarithmic scale, at the
/// least value above 0.
ColourScale colour_scale_of(const ScalarField& field, const FieldPicture& picture);

/// The writer for the format that the name's extension tells: .csv (columns index,sdf,weight and, at the faces of a
/// mesh whose file has polygons, polygon; shortest numbers that read back the same), .npy (the values,
/// one-dimensional), .ply (the shape, coloured, with the values as a property and the colours' range as a comment),
/// .png (a picture). Throws InputError for another extension.
FieldFileWriter field_file_writer(const std::filesystem::path& path, const FieldPicture& picture = {});

/// Writes normals at the samples of a shape to a file, whole or not at all.
using NormalFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Points& normals)>;

/// The writer for the format that the name's extension tells: .csv (columns index,nx,ny,nz,weight and polygon as
/// above), .npy (n x 3), .ply (the shape with the normals as properties of its faces or vertices), .xyz (a cloud of the
/// samples, x y z nx ny nz a line). Numbers read back the same. Throws InputError for another extension.
NormalFileWriter normal_file_writer(const std::filesystem::path& path);

}  // namespace shapegauge
