#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/experiments/datasets/classification.h"

namespace shapegauge {

/// Parses the Princeton Shape Benchmark's `.cla` format: "PSB 1"; the numbers of classes and of models; for each class
/// its name, its parent's name or 0, its number of models and that many ids. Words are separated by any white space,
/// there are no comments. Throws InputError with `source`, the line and what is wrong: another format or version, a
/// count that is not a whole number from 0 up, an end too early or too late, a parent that did not come before, a class
/// name or a model that occurs twice, totals that disagree, no models at all.
Classification parse_classification(std::string_view text, const std::string& source);

/// The text of a `.cla` file. It reads back as the same classification if that can be expressed; see
/// write_classification.
std::string format_classification(const Classification& classification);

/// Reads a `.cla` file; see parse_classification. Throws InputError also where the file cannot be read.
Classification read_classification(const std::filesystem::path& path);

/// Writes a `.cla` file, which reads back as the same classification. Throws InputError where the file cannot be
/// written or where the classification cannot be expressed: a name or an id that is empty or has white space in it, a
/// class named 0, a repeated name or model, a parent that does not come before its child, no models at all.
void write_classification(const std::filesystem::path& path, const Classification& classification);

}  // namespace shapegauge
