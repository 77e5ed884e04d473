// make_sample_views FOLDER: writes the sample page, for a browser to open.
#include <filesystem>
#include <iostream>

#include "shapegauge/core/io/file_bytes.h"
#include "tests/pages/sample_views.h"

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::cerr << "usage: make_sample_views FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  shapegauge::write_file_atomically(folder / "two.html", shapegauge::view_page(shapegauge::test_view::page()));
  return 0;
}
