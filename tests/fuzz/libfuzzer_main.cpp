// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_targets.h"

/// Entry point for Clang's libFuzzer. An escaping exception is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapegauge::fuzz::SHAPEGAUGE_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
