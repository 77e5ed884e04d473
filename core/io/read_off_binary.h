#pragma once

#include "shapegauge/core/io/off_header.h"
#include "shapegauge/core/io/text_scanner.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The shape in a binary OFF file's body, which the scanner has come to, after the header's line: big-endian, 32-bit.
Shape read_off_binary(const TextScanner& scanner, const OffHeader& header);

}  // namespace shapegauge
