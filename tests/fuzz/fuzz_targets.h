#pragma once

#include <string_view>

/// What is fuzzed: functions that any bytes at all may be handed to. Each returns whether the bytes were of use (false:
/// they were refused with an InputError, as they should be) and throws std::logic_error where a promise is broken; any
/// other exception breaks one, too.
namespace shapegauge::fuzz {

/// Shape readers. What is read has finite coordinates and indices within range.
/// @{
bool read_off(std::string_view bytes);
bool read_obj(std::string_view bytes);
bool read_ply(std::string_view bytes);
bool read_stl(std::string_view bytes);
bool read_gltf(std::string_view bytes);
/// @}

/// A `.cla` file: what is read is written and read again as the same.
bool classification(std::string_view bytes);

/// Distance matrices: what is read is square and not empty.
/// @{
bool npy(std::string_view bytes);
bool text_matrix(std::string_view bytes);
bool csv_matrix(std::string_view bytes);
bool psb_matrix(std::string_view bytes);
/// @}

/// Tables of numbers that need not be square: what is read is not empty, and has an id for each row and column or none.
/// @{
bool npy_table(std::string_view bytes);
bool csv_table(std::string_view bytes);
/// @}

/// An array of strings: what is read is not empty.
bool npy_strings(std::string_view bytes);

/// Ranked lists and judgements: what is read has queries, and lists have models.
/// @{
bool trec_run(std::string_view bytes);
bool ranked_lists(std::string_view bytes);
bool qrels(std::string_view bytes);
/// @}

/// A .seg file of a mesh with as many faces as it has line ends: what is read has a segment of 0 or more for each.
bool seg(std::string_view bytes);

/// A configuration, and after each line end followed by `--set ` an override. What is read, with all defaults filled
/// in, is a configuration again.
bool configuration(std::string_view bytes);

/// A small shape (soup_from_bytes.h), sampled and measured: the values of both SDFs are not negative, and finite except
/// where the conventional SDF has no answer.
bool shape_sdf(std::string_view bytes);

}  // namespace shapegauge::fuzz
