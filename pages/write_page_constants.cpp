// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <span>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/pages/page_constants.h"

// write_page_constants FILE: writes the module pages/common/constants.mjs.
int main(int count, char** values) {
  const std::span<char*> arguments(values, static_cast<std::size_t>(count));
  if (arguments.size() != 2) return EXIT_FAILURE;
  shapegauge::write_file_atomically(arguments[1], shapegauge::page_constants_script());
  return EXIT_SUCCESS;
}
