#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>

#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Writes the values of a field at the samples of a shape to a file, whole or not at all.
using FieldFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Eigen::VectorXd& values)>;

/// How a picture of a field is taken.
struct FieldPicture {
  RenderOptions render;
  bool principal = false;  ///< seen along the shape's own axes (principal_view()) instead of from `render`'s direction
};

/// The writer for the format that the name's extension tells: .csv (columns index,sdf,weight and, at the faces of a
/// mesh whose file has polygons, polygon; shortest numbers that read back the same), .npy (the values,
/// one-dimensional), .ply (the shape, coloured, with the values as a property), .png (a picture). Colours go from the
/// smallest value to the largest. Throws InputError for another extension.
FieldFileWriter field_file_writer(const std::filesystem::path& path, const FieldPicture& picture = {});

/// Writes normals at the samples of a shape to a file, whole or not at all.
using NormalFileWriter =
    std::function<void(const std::filesystem::path&, const Shape&, const Samples&, const Points& normals)>;

/// The writer for the format that the name's extension tells: .csv (columns index,nx,ny,nz,weight and polygon as
/// above), .npy (n x 3), .ply (the shape with the normals as properties of its faces or vertices), .xyz (a cloud of the
/// samples, x y z nx ny nz a line). Numbers read back the same. Throws InputError for another extension.
NormalFileWriter normal_file_writer(const std::filesystem::path& path);

}  // namespace shapegauge
