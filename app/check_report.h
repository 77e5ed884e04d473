// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "shapegauge/core/check/part_check.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/datasets/files/table.h"

/// Formats of the reports of `shapegauge check`. `unit` is the unit of the file's coordinates; empty if unknown.

namespace shapegauge {

/// Shape that was checked for thin walls and narrow gaps, with its report.
struct CheckedPart {
  std::string name;
  PartReport report;
};

/// Formats the report on a part as text: tables of the largest thin regions, and the verdict. Lengths are in `unit`.
std::string check_text(const CheckedPart& part, const std::string& unit);

/// Formats the report on a part as JSON, with the face indices of each thin region.
nlohmann::ordered_json check_json(const CheckedPart& part, const std::string& unit);

/// Makes a table with one row for each thin region of the parts.
TextTable check_table(std::span<const CheckedPart> parts);

/// Writer of the surface of a part to a file; triangles are split along the borders of thin regions.
using SurfaceWriter = std::function<void(const std::filesystem::path&, const CheckedPart&)>;

/// Returns the writer for the extension of a file name. `up` is the vertical axis in pages and pictures. Throws
/// InputError for an unsupported extension.
SurfaceWriter surface_writer(const std::filesystem::path& name, const std::string& unit, UpAxis up);

}  // namespace shapegauge
