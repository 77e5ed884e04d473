// SPDX-License-Identifier: GPL-3.0-or-later
// Writes CGAL's segmentations for evaluate-segmentation:
//
//     segment_by_cgal CLUSTERS SMOOTHING FOLDER MESH...
//
// FOLDER/MESH.seg has one line per face. Meshes unsupported by CGAL are reported and omitted.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "benchmarks/cgal_segmentation.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/segmentation/seg_file.h"

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  if (argc < 5) {
    std::cerr << "usage: segment_by_cgal CLUSTERS SMOOTHING FOLDER MESH...\n";
    return 2;
  }
  int failed = 0;
  try {
    const int clusters = std::stoi(argv[1]);
    const double smoothing = std::stod(argv[2]);
    const fs::path folder = argv[3];
    fs::create_directories(folder);
    for (int i = 4; i < argc; ++i) {
      const fs::path mesh = argv[i];
      try {
        const auto labels = shapegauge::cgal_segmentation(shapegauge::read_shape(mesh), clusters, smoothing);
        shapegauge::write_seg(folder / mesh.stem().concat(".seg"), labels);
      } catch (const std::exception& error) {
        std::cerr << mesh.string() << ": " << error.what() << '\n';
        ++failed;
      }
    }
  } catch (const std::exception& error) {
    std::cerr << "segment_by_cgal: error: " << error.what() << '\n';
    return 2;
  }
  return failed > 0 ? 1 : 0;
}
