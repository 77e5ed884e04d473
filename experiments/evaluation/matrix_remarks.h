#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapegauge/metrics/matrix_checks.h"

namespace shapegauge {

/// What was found in a matrix, a sentence each, with what it does to the figures. ids are those of the rows. `negated`:
/// the matrix was one of similarities, and they were negated, so that negative entries mean nothing.
std::vector<std::string> matrix_remarks(const MatrixFindings& findings, std::span<const std::string> ids, bool negated);

}  // namespace shapegauge
