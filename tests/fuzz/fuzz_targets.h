// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// Fuzz targets: functions of arbitrary bytes. Each returns whether the bytes were accepted (false:
/// rejected with an InputError) and throws std::logic_error if a guarantee is violated; any
/// other exception is a violation, too.
namespace shapegauge::fuzz {

/// Shape readers. Shapes must have finite coordinates and indices within range.
/// @{
bool read_off(std::string_view bytes);
bool read_obj(std::string_view bytes);
bool read_ply(std::string_view bytes);
bool read_stl(std::string_view bytes);
bool read_gltf(std::string_view bytes);
/// @}

/// A `.cla` file: writing and reading must reproduce it.
bool classification(std::string_view bytes);

/// Distance matrices: must be square and not empty.
/// @{
bool npy(std::string_view bytes);
bool text_matrix(std::string_view bytes);
bool csv_matrix(std::string_view bytes);
bool psb_matrix(std::string_view bytes);
/// @}

/// Rectangular tables of numbers: must not be empty, and must have ids for all rows and columns or none.
/// @{
bool npy_table(std::string_view bytes);
bool csv_table(std::string_view bytes);
/// @}

/// Arrays of strings: must not be empty.
bool npy_strings(std::string_view bytes);

/// Ranked lists and judgements: must have queries, and lists must have models.
/// @{
bool trec_run(std::string_view bytes);
bool ranked_lists(std::string_view bytes);
bool qrels(std::string_view bytes);
/// @}

/// A .seg file of a mesh with one face per newline: every face must have a segment of 0 or more.
bool seg(std::string_view bytes);

/// A configuration, followed by overrides after newlines with `--set `. A configuration that is read must, with all
/// defaults inserted, be readable again.
bool configuration(std::string_view bytes);

/// A small shape (soup_from_bytes.h), sampled and measured: values of both SDFs must be non-negative, and finite except
/// where the conventional SDF is undefined.
bool shape_sdf(std::string_view bytes);

}  // namespace shapegauge::fuzz
