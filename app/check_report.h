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

/// Shape of a part to be manufactured that was checked for thin walls and narrow gaps, with its report.
struct CheckedPart {
  std::string name;   ///< path of the shape's file
  PartReport report;  ///< thin walls, narrow gaps and closed voids that were found
};

/// Formats the report on a part as text: tables of the largest thin regions, and the verdict. Lengths are in `unit`.
std::string check_text(const CheckedPart& part, const std::string& unit);

/// Formats the report on a part as JSON, with the face indices of each thin region.
nlohmann::ordered_json check_json(const CheckedPart& part, const std::string& unit);

/// Makes a table of all checked parts for CSV and other formats: one row per region of a thin wall or narrow
/// gap.
TextTable check_table(std::span<const CheckedPart> parts);

/// Function that writes the checked surface of a part to a file, coloured by thickness relative to the limit. Triangles
/// are split along the borders of thin regions.
using SurfaceWriter = std::function<void(const std::filesystem::path&, const CheckedPart&)>;

/// Returns the writer for the extension of the file name `name`. `up` is the vertical axis in pages and pictures.
/// Throws InputError for an unsupported extension.
SurfaceWriter surface_writer(const std::filesystem::path& name, const std::string& unit, UpAxis up);

}  // namespace shapegauge
