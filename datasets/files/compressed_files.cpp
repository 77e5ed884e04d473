#include "shapegauge/datasets/files/compressed_files.h"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
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
  const std::size_t most = most_unpacked_bytes(packed);
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

}  // namespace

std::string format_extension(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".gz" ? lower_case(path.stem().extension().string()) : extension;
}

std::size_t most_unpacked_bytes(std::size_t packed) {
  constexpr std::size_t always = std::size_t{256} << 20;
  constexpr std::size_t never = std::size_t{16} << 30;
  constexpr std::size_t ratio = 50;
  return packed > never / ratio ? never : std::max(always, ratio * packed);
}

void fail_unpacking(const std::string& source, std::size_t packed) {
  throw InputError(
      fmt::format("{}: its {} bytes unpack to more than {} MiB, too much for a table of numbers; if that is correct, "
                  "unpack it first",
                  source, packed, most_unpacked_bytes(packed) >> 20U));
}

std::string read_plain_bytes(const std::filesystem::path& path) {
  std::string bytes = read_file_bytes(path);
  if (lower_case(path.extension().string()) != ".gz") return bytes;
  constexpr std::string_view what = "not a gzip file, or damaged";
  const Archive opened(archive_read_new());
  archive_read_support_filter_gzip(opened.get());
  archive_read_support_format_raw(opened.get());
  archive_entry* entry = nullptr;
  if (archive_read_open_memory(opened.get(), bytes.data(), bytes.size()) != ARCHIVE_OK ||
      archive_read_next_header(opened.get(), &entry) != ARCHIVE_OK ||
      archive_filter_code(opened.get(), 0) != ARCHIVE_FILTER_GZIP) {
    fail(opened.get(), path.string(), what);
  }
  return entry_bytes(opened.get(), bytes.size(), path.string(), what);
}

std::string array_in_npz(std::string_view bytes, const std::string& source) {
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
    if (names.size() == 1) array = entry_bytes(opened.get(), bytes.size(), source, what);
  }
  if (status != ARCHIVE_EOF) fail(opened.get(), source, what);
  if (names.size() == 1) return array;
  if (names.empty()) throw InputError(fmt::format("{}: the archive has no array", source));
  throw InputError(fmt::format("{}: the archive has {} arrays ({}); save the matrix alone, or as .npy", source,
                               names.size(), printable(fmt::format("{}", fmt::join(names, ", ")), 60)));
}

}  // namespace shapegauge
