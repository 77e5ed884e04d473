#include <exception>
#include <iostream>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/offset_sdf.h"

int main(int count, char** arguments) {
  try {
    const shapegauge::Shape shape = shapegauge::read_shape(count > 1 ? arguments[1] : "shape.off");
    const shapegauge::Samples samples = shapegauge::sample_shape(shape, shapegauge::SampleSite::faces);
    const shapegauge::OffsetSdfResult sdf = shapegauge::offset_sdf(shape, samples, {.offset = 0.01});
    std::cout << sdf.values.transpose().format(Eigen::IOFormat(3)) << '\n';
  } catch (const std::exception& error) {  // states the file, the line and the problem
    std::cerr << error.what() << '\n';
    return 1;
  }
}
