#include <iostream>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/offset_sdf.h"

int main(int, char** arguments) {
  const shapegauge::Shape shape = shapegauge::read_shape(arguments[1]);
  const shapegauge::Samples samples = shapegauge::sample_shape(shape, shapegauge::SampleSite::faces);
  const shapegauge::OffsetSdfResult sdf = shapegauge::offset_sdf(shape, samples, {.offset = 0.01});
  std::cout << sdf.values.transpose().format(Eigen::IOFormat(3)) << '\n';
}
