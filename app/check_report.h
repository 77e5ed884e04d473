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

/// Formats of the reports of `check`. `unit` is that of the file's coordinates; empty if unknown.

namespace shapegauge {

/// Report on one of the shapes.
struct CheckedPart {
  std::string name;
  PartReport report;
};

/// Formats the report as text: tables of the largest regions and the verdict.
std::string check_text(const CheckedPart& part, const std::string& unit);

/// Formats the report as JSON, with the faces of each region.
nlohmann::ordered_json check_json(const CheckedPart& part, const std::string& unit);

/// Makes a table with one row for each region of the parts.
TextTable check_table(std::span<const CheckedPart> parts);

/// Writes the surface of a part, divided along regions.
using SurfaceWriter = std::function<void(const std::filesystem::path&, const CheckedPart&)>;

/// Returns the writer for the name's extension. `up` is vertical in pages and pictures. Throws InputError for another
/// extension.
SurfaceWriter surface_writer(const std::filesystem::path& name, const std::string& unit, UpAxis up);

}  // namespace shapegauge
