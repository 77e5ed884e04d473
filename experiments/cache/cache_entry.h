#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shapegauge/experiments/cache/entry_kind.h"

namespace shapegauge {

/// The bytes of the file of an entry: a line that names the format, a line `<kind> <key>`, a line `<bytes> <SHA-256>`
/// of what follows, and that.
std::string encode_entry(EntryKind kind, std::string_view key, std::string_view content);

/// What the file of an entry holds; nothing where a byte of it is not what was written: another length, another
/// checksum, another key.
std::optional<std::string> decode_entry(EntryKind kind, std::string_view key, std::string_view bytes);

}  // namespace shapegauge
