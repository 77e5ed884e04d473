// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/compressed_files.h"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <new>
#include <vector>
#include <zlib.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/base/utf8.h"
#include "shapegauge/core/io/file_bytes.h"

namespace shapegauge {

namespace {

struct FreeArchive {
  void operator()(archive* opened) const { archive_read_free(opened); }
};
using Archive = std::unique_ptr<archive, FreeArchive>;

[[noreturn]] void fail(archive* opened, const std::string& source, std::string_view what) {
  const char* const reason = archive_error_string(opened);
  throw InputError(fmt::format("{}: {}: {}", source, what, reason != nullptr ? reason : "the file is damaged"));
}

// Returns the contents of the archive's current entry. `packed` is the size of the archive.
std::string entry_bytes(archive* opened, std::size_t packed, const std::string& source, std::string_view what) {
  const std::size_t most = max_unpacked_bytes(packed);
  std::string bytes;
  std::string part(1 << 16, '\0');
  while (true) {
    const la_ssize_t count = archive_read_data(opened, part.data(), part.size());
    if (count < 0) fail(opened, source, what);
    if (count == 0) return bytes;
    if (bytes.size() + static_cast<std::size_t>(count) > most) fail_unpacking(source, packed);
    bytes.append(part, 0, static_cast<std::size_t>(count));
  }
}

struct EndInflation {
  void operator()(z_stream* stream) const { inflateEnd(stream); }
};

// First byte of each member of a gzip file.
constexpr unsigned first_byte = 0x1f;

constexpr std::string_view trailing_bytes = "other bytes follow its end";

// Describes the fault of a gzip file that inflate() refuses.
std::string_view inflation_fault(const z_stream& stream, int status, bool is_first_member) {
  if (status == Z_DATA_ERROR && !is_first_member && stream.total_out == 0) return trailing_bytes;
  if (status == Z_BUF_ERROR) return "it ends too early";
  return stream.msg != nullptr ? stream.msg : "its data is invalid";
}

[[noreturn]] void fail_inflation(const std::string& source, std::string_view fault) {
  throw InputError(fmt::format("{}: not a gzip file, or damaged: {}", source, fault));
}

// Returns the contents of a gzip file of one or several members. zlib compares the checksum and the size of each.
std::string unpacked_gzip(std::string_view packed, const std::string& source) {
  const std::size_t most = max_unpacked_bytes(packed.size());
  constexpr int gzip_only = 16;
  z_stream stream = {};
  if (inflateInit2(&stream, MAX_WBITS + gzip_only) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, EndInflation> end(&stream);
  std::string bytes;
  std::string part(1 << 16, '\0');
  bool is_first_member = true;
  std::string_view rest = packed;
  while (true) {
    if (stream.avail_in == 0) {  // the number of bytes has 32 bits
      const std::string_view next = rest.substr(0, std::size_t{1} << 30);
      stream.next_in = reinterpret_cast<const Bytef*>(next.data());
      stream.avail_in = static_cast<uInt>(next.size());
      rest.remove_prefix(next.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t count = part.size() - stream.avail_out;
    if (bytes.size() + count > most) fail_unpacking(source, packed.size());
    bytes.append(part, 0, count);
    const bool at_end = stream.avail_in == 0 && rest.empty();
    if (status == Z_STREAM_END && at_end) return bytes;
    if (status == Z_STREAM_END) {
      const unsigned next = stream.avail_in > 0 ? *stream.next_in : static_cast<unsigned char>(rest.front());
      if (next != first_byte) fail_inflation(source, trailing_bytes);
      inflateReset(&stream);
      is_first_member = false;
    } else if (status != Z_OK) {
      fail_inflation(source, inflation_fault(stream, status, is_first_member));
    }
  }
}

}  // namespace

std::string format_extension(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".gz" ? lower_case(path.stem().extension().string()) : extension;
}

std::size_t max_unpacked_bytes(std::size_t packed) {
  constexpr std::size_t always = std::size_t{256} << 20;
  constexpr std::size_t never = std::size_t{16} << 30;
  constexpr std::size_t ratio = 50;
  return packed > never / ratio ? never : std::max(always, ratio * packed);
}

void fail_unpacking(const std::string& source, std::size_t packed) {
  throw InputError(
      fmt::format("{}: its {} bytes unpack to more than {} MiB, too much for a table of numbers; if that is correct, "
                  "unpack it first",
                  source, packed, max_unpacked_bytes(packed) >> 20U));
}

std::string read_plain_bytes(const std::filesystem::path& path) {
  std::string bytes = read_file_bytes(path);
  if (lower_case(path.extension().string()) != ".gz") return bytes;
  return unpacked_gzip(bytes, path.string());
}

std::string read_plain_text(const std::filesystem::path& path) { return to_utf8(read_plain_bytes(path)); }

std::string extract_npz_array(std::string_view bytes, const std::string& source, const std::string& variable) {
  constexpr std::string_view what = "not a .npz archive, or damaged";
  const Archive opened(archive_read_new());
  archive_read_support_format_zip(opened.get());
  if (archive_read_open_memory(opened.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) {
    fail(opened.get(), source, what);
  }
  std::vector<std::string> names;
  std::string array;
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(opened.get(), &entry)) == ARCHIVE_OK) {
    const char* const name = archive_entry_pathname(entry);
    if (name == nullptr || !std::string_view(name).ends_with(".npy")) continue;
    names.emplace_back(name, std::string_view(name).size() - 4);
    const bool requested = variable.empty() ? names.size() == 1 : names.back() == variable;
    if (requested) array = entry_bytes(opened.get(), bytes.size(), source, what);
  }
  if (status != ARCHIVE_EOF) fail(opened.get(), source, what);
  const bool found = variable.empty() ? names.size() == 1 : std::ranges::find(names, variable) != names.end();
  if (found) return array;
  if (names.empty()) throw InputError(fmt::format("{}: the archive has no array", source));
  const std::string all = printable(fmt::format("{}", fmt::join(names, ", ")), 60);
  throw InputError(variable.empty() ? fmt::format("{}: the archive has {} arrays ({}); choose one with `variable`",
                                                  source, names.size(), all)
                                    : fmt::format("{}: no array {}; there are {}", source, quoted_word(variable), all));
}

}  // namespace shapegauge
