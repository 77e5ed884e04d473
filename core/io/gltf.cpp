// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <new>
#include <tiny_gltf.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"

namespace shapegauge {

namespace {

constexpr std::size_t max_gltf_items = 100'000'000;  // vertices or triangles: nodes repeat their meshes
constexpr std::size_t max_nesting = 200;             // of JSON: the library reads it recursively
constexpr std::string_view glb_magic = "glTF";

[[noreturn]] void fail(const std::string& name, std::string_view what) {
  throw InputError(fmt::format("{}: {}", name, what));
}

/// Files that the library opens next to the file.
struct GltfFiles {
  const ShapeSource* source = nullptr;
  std::vector<std::string> names = {};
  std::exception_ptr failure = nullptr;
};

bool is_picture(const std::string& file) {
  static constexpr std::array<std::string_view, 9> extensions{".png", ".jpg", ".jpeg", ".webp", ".ktx2",
                                                              ".gif", ".tga", ".bmp",  ".dds"};
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  return std::ranges::count(extensions, extension) > 0;
}

/// Reports no size: the source limits what it reads. From tinygltf 2.9 on, callbacks without this one are not accepted.
template <typename Callbacks>
void set_size_callback(Callbacks& callbacks) {
  if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
    callbacks.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string&, void*) {
      *size = 0;
      return true;
    };
  }
}

/// Returns the library's file callbacks: buffers through the source, which rejects files elsewhere; no images.
tinygltf::FsCallbacks callbacks_for(GltfFiles& files) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string& file, void*) { return !is_picture(file); };
  callbacks.ExpandFilePath = [](const std::string& file, void*) { return file; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* bytes, std::string*, const std::string& file, void* user) {
    auto& opened = *static_cast<GltfFiles*>(user);
    try {
      const std::string read = opened.source->read_neighbour(file);
      bytes->assign(read.begin(), read.end());
      opened.names.push_back(file);
      return true;
    } catch (...) {
      opened.failure = std::current_exception();
      return false;
    }
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  set_size_callback(callbacks);
  callbacks.user_data = &files;
  return callbacks;
}

bool pass_over_picture(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                       void*) {
  return true;
}

/// Throws InputError if brackets are nested deeper than the library supports.
void require_flat(std::string_view json, const std::string& name) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '{' || c == '[')) {
      if (++depth > max_nesting)
        fail(name, fmt::format("its JSON is nested more than {} levels deep; export it again", max_nesting));
    } else if (!in_string && (c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
}

/// Returns the JSON of a GLB file; the length of the first chunk is in its bytes 12 to 15.
std::string_view json_of_glb(std::string_view bytes) {
  constexpr std::size_t header = 20;
  if (bytes.size() < header) return {};
  std::uint32_t length = 0;
  for (std::size_t k = 4; k-- > 0;) length = length * 256 + static_cast<unsigned char>(bytes[12 + k]);
  return bytes.substr(header, length);
}

tinygltf::Model load(const ShapeSource& source, GltfFiles& files) {
  const std::string& bytes = source.bytes;
  if (bytes.size() > std::numeric_limits<unsigned>::max())
    fail(source.name, "glTF files of more than 4 GB are not supported; export the model in parts");
  const bool binary = bytes.starts_with(glb_magic);
  require_flat(binary ? json_of_glb(bytes) : std::string_view(bytes), source.name);
  tinygltf::TinyGLTF loader;
  files.source = &source;
  loader.SetFsCallbacks(callbacks_for(files));
  loader.SetImageLoader(pass_over_picture, nullptr);
  tinygltf::Model model;
  std::string errors;
  std::string warnings;
  bool loaded = false;
  const auto length = static_cast<unsigned>(bytes.size());
  try {
    loaded = binary ? loader.LoadBinaryFromMemory(&model, &errors, &warnings,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()), length)
                    : loader.LoadASCIIFromString(&model, &errors, &warnings, bytes.data(), length, "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    errors = error.what();
  }
  if (files.failure) std::rethrow_exception(files.failure);
  if (loaded) return model;
  std::ranges::replace(errors, '\n', ' ');
  fail(source.name, fmt::format("it is no valid glTF and must be exported again: {}",
                                errors.empty() ? "it cannot be read" : printable(errors, 200)));
}

/// Refuses files with a required extension, as the standard demands, unless it is about surfaces and lights only or the
/// numbers of positions.
void require_readable(const tinygltf::Model& model, const std::string& name) {
  static constexpr std::array<std::string_view, 5> readable{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                            "KHR_lights_", "KHR_mesh_quantization"};
  for (const std::string& extension : model.extensionsRequired) {
    const auto begins = [&](std::string_view prefix) { return extension.starts_with(prefix); };
    if (std::ranges::any_of(readable, begins)) continue;
    const bool compressed = extension.find("compression") != std::string::npos;
    fail(name, fmt::format("it requires the extension {}, which is not read; export it without {}",
                           quoted_word(extension), compressed ? "compression" : "it"));
  }
}

template <typename Item>
const Item& item_at(const std::vector<Item>& items, int index, const char* what, const std::string& name) {
  if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
    fail(name,
         fmt::format("it refers to {} {} (numbered from 0), but has {}; export it again", what, index, items.size()));
  }
  return items[static_cast<std::size_t>(index)];
}

/// Reads a number of a component type. Normalised integers become -1 to 1, or 0 to 1.
template <typename Number>
double number_at(const unsigned char* bytes, bool normalised) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  if constexpr (std::is_floating_point_v<Number>) {
    return number;
  } else {
    if (!normalised) return number;
    return std::max(-1.0, static_cast<double>(number) / std::numeric_limits<Number>::max());
  }
}

double component_at(const unsigned char* bytes, int type, bool normalised) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return number_at<std::int8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_at<std::uint8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return number_at<std::int16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_at<std::uint16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_at<std::uint32_t>(bytes, normalised);
    default:
      return number_at<float>(bytes, normalised);
  }
}

/// Items of equal size in a buffer.
struct BufferItems {
  const unsigned char* first = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;

  [[nodiscard]] const unsigned char* at(std::size_t i) const { return first + i * stride; }
};

/// Returns the items in a part of a buffer. A `stride` of 0 means contiguous items.
BufferItems items_in(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t count,
                     std::size_t size, const std::string& name) {
  const tinygltf::BufferView& view = item_at(model.bufferViews, view_index, "buffer view", name);
  const tinygltf::Buffer& buffer = item_at(model.buffers, view.buffer, "buffer", name);
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : size;
  const std::size_t available = buffer.data.size();
  const bool view_fits = view.byteOffset <= available && view.byteLength <= available - view.byteOffset;
  const bool fits = view_fits && count > 0 && offset <= view.byteLength && size <= view.byteLength - offset &&
                    (count - 1) <= (view.byteLength - offset - size) / stride;
  if (!fits)
    fail(name, fmt::format("buffer view {} ends before its {} items; the file is damaged: export it again", view_index,
                           count));
  return {.first = buffer.data.data() + view.byteOffset + offset, .count = count, .stride = stride};
}

std::size_t size_of_component(int type, const std::string& name) {
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
  if (size < 1 || size > 4)
    fail(name, fmt::format("numbers of component type {} are unknown in glTF; export the file again", type));
  return static_cast<std::size_t>(size);
}

using Positions = std::vector<Eigen::Vector3d>;

/// Applies the replacements of a sparse accessor.
void replace_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, Positions& positions,
                    const std::string& name) {
  const auto& sparse = accessor.sparse;
  if (!sparse.isSparse || sparse.count <= 0) return;
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::size_t size = size_of_component(accessor.componentType, name);
  // Signed in older versions of tinygltf.
  if (std::cmp_less(sparse.indices.byteOffset, 0) || std::cmp_less(sparse.values.byteOffset, 0)) {
    fail(name, "a sparse accessor has a negative offset; export the file again");
  }
  const BufferItems indices =
      items_in(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
               size_of_component(sparse.indices.componentType, name), name);
  const BufferItems values = items_in(model, sparse.values.bufferView,
                                      static_cast<std::size_t>(sparse.values.byteOffset), count, 3 * size, name);
  for (std::size_t i = 0; i < count; ++i) {
    const double index = component_at(indices.at(i), sparse.indices.componentType, false);
    if (!(index >= 0 && index < static_cast<double>(positions.size())))
      fail(name, fmt::format("a sparse accessor replaces position {}, but there are {}; export the file again", index,
                             positions.size()));
    for (int k = 0; k < 3; ++k) {
      positions[static_cast<std::size_t>(index)][k] =
          component_at(values.at(i) + static_cast<std::size_t>(k) * size, accessor.componentType, accessor.normalized);
    }
  }
}

/// Positions that an accessor finds in a buffer.
Positions stored_positions(const tinygltf::Model& model, const tinygltf::Accessor& accessor, const std::string& name) {
  const std::size_t size = size_of_component(accessor.componentType, name);
  const BufferItems items = items_in(model, accessor.bufferView, accessor.byteOffset, accessor.count, 3 * size, name);
  Positions positions(items.count);
  for (std::size_t i = 0; i < items.count; ++i) {
    for (int k = 0; k < 3; ++k) {
      positions[i][k] =
          component_at(items.at(i) + static_cast<std::size_t>(k) * size, accessor.componentType, accessor.normalized);
    }
  }
  return positions;
}

/// Positions of an accessor without a buffer view: zeros, which a sparse accessor replaces.
Positions zero_positions(const tinygltf::Model& model, const tinygltf::Accessor& accessor, const std::string& name) {
  if (!accessor.sparse.isSparse)
    fail(name, "the positions of a mesh have no buffer view; export the file without compression");
  std::size_t bytes = 0;
  for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
  if (accessor.count > bytes)
    fail(name, fmt::format("a mesh has {} positions, but the file only {} bytes of data; export it again",
                           accessor.count, bytes));
  return Positions(accessor.count, Positions::value_type::Zero());
}

Positions positions_of(const tinygltf::Model& model, int accessor_index, const std::string& name) {
  const tinygltf::Accessor& accessor = item_at(model.accessors, accessor_index, "accessor", name);
  if (accessor.type != TINYGLTF_TYPE_VEC3)
    fail(name, "the positions of a mesh are no vectors of three numbers; export the file again");
  Positions positions =
      accessor.bufferView < 0 ? zero_positions(model, accessor, name) : stored_positions(model, accessor, name);
  replace_sparse(model, accessor, positions, name);
  return positions;
}

void require_indices(const tinygltf::Accessor& accessor, const std::string& name) {
  static constexpr std::array types{TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT};
  if (accessor.type != TINYGLTF_TYPE_SCALAR || std::ranges::count(types, accessor.componentType) == 0) {
    fail(name, "the indices of a mesh are no unsigned integers; export the file again");
  }
  if (accessor.sparse.isSparse)
    fail(name,
         "the indices of a mesh are a sparse accessor, which is not supported; export the file without sparse "
         "accessors");
  if (accessor.bufferView < 0)
    fail(name, "the indices of a mesh have no buffer view; export the file without compression");
}

/// Returns the corners of a primitive: its indices, or all of its vertices in order.
std::vector<std::int32_t> corners_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                     std::size_t vertices, const std::string& name) {
  std::vector<std::int32_t> corners;
  if (primitive.indices < 0) {
    for (std::size_t i = 0; i < vertices; ++i) corners.push_back(static_cast<std::int32_t>(i));
    return corners;
  }
  const tinygltf::Accessor& accessor = item_at(model.accessors, primitive.indices, "accessor", name);
  require_indices(accessor, name);
  const std::size_t size = size_of_component(accessor.componentType, name);
  const BufferItems items = items_in(model, accessor.bufferView, accessor.byteOffset, accessor.count, size, name);
  corners.reserve(items.count);
  for (std::size_t i = 0; i < items.count; ++i) {
    const double index = component_at(items.at(i), accessor.componentType, false);
    if (!(index >= 0 && index < static_cast<double>(vertices))) {
      fail(name, fmt::format(
                     "index {} of a mesh refers to vertex {}, but there are {}, numbered from 0; export the file again",
                     i, index, vertices));
    }
    corners.push_back(static_cast<std::int32_t>(index));
  }
  return corners;
}

/// Returns the triangles of a primitive; none for points and lines.
std::vector<std::array<std::int32_t, 3>> triangles_of(const std::vector<std::int32_t>& corners, int mode) {
  std::vector<std::array<std::int32_t, 3>> triangles;
  const std::size_t count = corners.size();
  if (mode == TINYGLTF_MODE_TRIANGLES || mode < 0) {
    for (std::size_t i = 0; i + 2 < count; i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    for (std::size_t i = 0; i + 2 < count; ++i) {
      const std::size_t odd = i % 2;
      triangles.push_back({corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    }
  } else if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
    for (std::size_t i = 1; i + 1 < count; ++i) triangles.push_back({corners[i], corners[i + 1], corners[0]});
  }
  return triangles;
}

Eigen::Affine3d transform_of(const tinygltf::Node& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.matrix.size() == 16) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());  // column by column
    transform.makeAffine();
    return transform;
  }
  if (node.translation.size() == 3) transform.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
  if (node.rotation.size() == 4) {
    const auto& q = node.rotation;
    const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
    if (rotation.norm() > 0) transform.rotate(rotation.normalized());
  }
  if (node.scale.size() == 3) transform.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
  return transform;
}

/// Collects the meshes of a scene.
class GltfScene {
 public:
  GltfScene(const tinygltf::Model& model, std::string name)
      : model_(model), name_(std::move(name)), visited_(model.nodes.size(), false) {}

  Shape read() {
    for (const int root : roots()) visit(root);
    if (soup_.triangles() == 0) add_points();
    if (soup_.vertices() == 0) fail(name_, "its scene has no triangles or points; export it with a mesh");
    return soup_.shape();
  }

 private:
  struct WaitingNode {
    int node;
    Eigen::Affine3d parent;
  };

  struct PointsInstance {
    int accessor;
    Eigen::Affine3d transform;
  };

  /// Returns the roots of the default scene or, without scenes, of all nodes.
  [[nodiscard]] std::vector<int> roots() const {
    if (!model_.scenes.empty()) {
      return item_at(model_.scenes, std::max(0, model_.defaultScene), "scene", name_).nodes;
    }
    std::vector<bool> has_parent(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) {
        item_at(model_.nodes, child, "node", name_);
        has_parent[static_cast<std::size_t>(child)] = true;
      }
    }
    std::vector<int> all;
    for (std::size_t i = 0; i < has_parent.size(); ++i) {
      if (!has_parent[i]) all.push_back(static_cast<int>(i));
    }
    return all;
  }

  void visit(int root) {
    std::vector<WaitingNode> waiting{{root, Eigen::Affine3d::Identity()}};
    while (!waiting.empty()) {
      const WaitingNode next = waiting.back();
      waiting.pop_back();
      const tinygltf::Node& node = item_at(model_.nodes, next.node, "node", name_);
      if (visited_[static_cast<std::size_t>(next.node)]) {
        fail(name_, fmt::format("node {} has two parents, or is its own parent; export the file again", next.node));
      }
      visited_[static_cast<std::size_t>(next.node)] = true;
      const Eigen::Affine3d transform = next.parent * transform_of(node);
      if (node.mesh >= 0) add_mesh(item_at(model_.meshes, node.mesh, "mesh", name_), transform);
      for (std::size_t k = node.children.size(); k-- > 0;) waiting.push_back({node.children[k], transform});
    }
  }

  void add_mesh(const tinygltf::Mesh& mesh, const Eigen::Affine3d& transform) {
    std::map<int, std::pair<std::size_t, std::size_t>> added;  // per accessor: first vertex, number of vertices
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      const auto found = primitive.attributes.find("POSITION");
      if (found == primitive.attributes.end()) continue;
      const int mode = primitive.mode;
      if (mode == TINYGLTF_MODE_POINTS) {
        points_.push_back({found->second, transform});
        continue;
      }
      if (mode != TINYGLTF_MODE_TRIANGLES && mode >= 0 && mode < TINYGLTF_MODE_TRIANGLE_STRIP) continue;  // lines
      if (!added.contains(found->second)) {
        const Positions positions = positions_of(model_, found->second, name_);
        added[found->second] = {soup_.vertices(), positions.size()};
        add_vertices(positions, transform);
      }
      const auto& [first, count] = added[found->second];
      const bool mirrored = transform.linear().determinant() < 0;
      const auto triangles = triangles_of(corners_of(model_, primitive, count, name_), mode);
      require_room(soup_.triangles(), triangles.size(), "triangles");
      for (std::array<std::int32_t, 3> triangle : triangles) {
        if (mirrored) std::swap(triangle[1], triangle[2]);
        soup_.begin_face();
        for (const std::int32_t corner : triangle) soup_.add_corner(static_cast<std::int32_t>(first) + corner);
      }
    }
  }

  void require_room(std::size_t present, std::size_t more, std::string_view what) const {
    if (more <= max_gltf_items - present) return;
    fail(name_, fmt::format("its scene has more than {} {}; export it in parts", max_gltf_items, what));
  }

  void add_vertices(const Positions& positions, const Eigen::Affine3d& transform) {
    require_room(soup_.vertices(), positions.size(), "vertices");
    for (const Eigen::Vector3d& position : positions) {
      const Eigen::Vector3d transformed = transform * position;
      if (!transformed.allFinite()) fail(name_, message_not_finite(static_cast<std::int64_t>(soup_.vertices())));
      soup_.add_vertex({transformed[0], transformed[1], transformed[2]});
    }
  }

  void add_points() {
    for (const PointsInstance& points : points_) {
      add_vertices(positions_of(model_, points.accessor, name_), points.transform);
    }
  }

  const tinygltf::Model& model_;
  std::string name_;
  std::vector<bool> visited_;
  SoupBuilder soup_;
  std::vector<PointsInstance> points_;
};

void check_gltf_header(const std::string& bytes, const std::string& name) {
  if (bytes.starts_with(glb_magic)) return;
  std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (bytes.starts_with("\xef\xbb\xbf")) first = bytes.find_first_not_of(" \t\r\n", 3);
  if (first == std::string::npos || bytes[first] != '{')
    fail(name, "not a glTF file: it is neither JSON nor binary glTF");
}

/// Returns the names of the neighbouring files that hold the buffers.
std::vector<std::string> gltf_neighbours(const ShapeSource& source) {
  GltfFiles files;
  load(source, files);
  return files.names;
}

}  // namespace

Shape read_gltf(const ShapeSource& source) {
  GltfFiles files;
  const tinygltf::Model model = load(source, files);
  require_readable(model, source.name);
  return GltfScene(model, source.name).read();
}

ShapeFormat gltf_format() {
  static constexpr std::array<std::string_view, 2> extensions{".gltf", ".glb"};
  return {.name = "glTF",
          .description = "glTF 2.0, JSON with buffers or binary: the meshes of its scene, placed by its nodes",
          .extensions = extensions,
          .begins_like = [](std::string_view bytes) { return bytes.starts_with(glb_magic); },
          .check_header = check_gltf_header,
          .read = read_gltf,
          .neighbours = gltf_neighbours,
          .y_is_up = true};
}

}  // namespace shapegauge
