#pragma once

#include <string>

namespace shapegauge {

/// The kind of processor and those of its instruction sets by which the libraries choose their code at run time, such
/// as "x86-64 sse4.2 avx2 fma avx512f": with others the last bits of values may differ.
std::string processor();

}  // namespace shapegauge
