#include "shapegauge/experiments/command_line/shape_argument.h"

namespace shapegauge {

void add_shape_argument(CLI::App& command, std::filesystem::path& input) {
  command.add_option("input", input, "Mesh or point cloud: OFF, OBJ, PLY, STL, XYZ, PWN, PTS or TXT")->required();
}

}  // namespace shapegauge
