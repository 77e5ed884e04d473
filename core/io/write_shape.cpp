#include "shapegauge/core/io/write_shape.h"

#include <fmt/format.h>
#include <string>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/write_off.h"
#include "shapegauge/core/io/write_ply.h"

namespace shapegauge {

ShapeWriter shape_writer(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".off" || extension == ".OFF") return write_off;
  if (extension == ".ply" || extension == ".PLY") return write_ply;
  throw InputError(fmt::format("cannot write {}: the name must end in .off or .ply", path.string()));
}

}  // namespace shapegauge
