// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/open_matrix.h"

#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel_parts.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/npy.h"

namespace shapegauge {

namespace {

// File with random access.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) : path_(path), descriptor_(::open(path.c_str(), O_RDONLY)) {
    if (descriptor_ < 0) fail();
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { ::close(descriptor_); }

  void read(std::span<char> bytes, std::size_t offset) const {
    while (!bytes.empty()) {
      const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      if (count == 0) throw InputError(fmt::format("{}: the file was truncated while it was read", path_.string()));
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      offset += static_cast<std::size_t>(count);
    }
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail() const {
    throw InputError(fmt::format("cannot read {}: {}", path_.string(), std::generic_category().message(errno)));
  }

  std::filesystem::path path_;
  int descriptor_;
};

DistanceMatrix read_block(const OpenFile& file, const NpyTable& table, TableShape shape, const MatrixBlock& block) {
  DistanceMatrix numbers(block.rows, block.columns);
  const auto row_bytes = static_cast<std::size_t>(block.columns) * table.numbers.bytes;
  interruptible_parallel_for(
      tbb::blocked_range<Eigen::Index>(0, block.rows), [&](const tbb::blocked_range<Eigen::Index>& some) {
        std::vector<char> bytes(row_bytes);
        for (Eigen::Index row = some.begin(); row < some.end(); ++row) {
          const Eigen::Index entry = (block.first_row + row) * table.columns + block.first_column;
          file.read(bytes, table.data_begin + static_cast<std::size_t>(entry) * table.numbers.bytes);
          with_source(file.path().string(), [&] {
            table.numbers.decode(bytes.data(), static_cast<std::size_t>(block.columns), numbers.row(row).data());
          });
        }
      });
  replace_or_refuse_nan(numbers, {block.first_row, block.first_column}, shape, file.path());
  return numbers;
}

// Returns the layout for reading a file in blocks; nothing if that is not possible.
std::optional<NpyTable> block_layout(const std::filesystem::path& path, TableShape shape) {
  const std::string extension = lower_case(path.extension().string());
  const bool psb = extension == ".matrix";
  std::error_code unreadable;
  if ((!psb && extension != ".npy") || !std::filesystem::is_regular_file(path, unreadable)) return std::nullopt;
  const auto bytes = static_cast<std::size_t>(std::filesystem::file_size(path));
  constexpr std::size_t longest_usual_header = 1 << 17;
  const std::string beginning = read_file_bytes(path, longest_usual_header);  // rejects empty and unreadable files
  if (psb) {
    const Eigen::Index size = psb_matrix_size(bytes, path.string());
    return NpyTable{.rows = size, .columns = size, .numbers = float32_format()};
  }
  const std::vector<std::uint64_t> sizes = parse_npy_header(beginning, path.string()).shape;
  if (shape == TableShape::square && is_condensed_shape(sizes)) return std::nullopt;
  const NpyTable table = parse_npy_table_header(beginning, bytes, shape, path.string());
  if (table.column_by_column) return std::nullopt;
  return table;
}

}  // namespace

OpenMatrix open_matrix(LabelledTable table) {
  const auto shared = std::make_shared<const LabelledTable>(std::move(table));
  const auto read = [shared](const MatrixBlock& block) -> DistanceMatrix {
    return shared->numbers.block(block.first_row, block.first_column, block.rows, block.columns);
  };
  return {.rows = shared->numbers.rows(),
          .columns = shared->numbers.cols(),
          .read = read,
          .row_ids = shared->row_ids,
          .column_ids = shared->column_ids};
}

OpenMatrix open_matrix(const std::filesystem::path& path, TableShape shape, const std::string& variable) {
  if (const auto layout = variable.empty() ? block_layout(path, shape) : std::nullopt) {
    const auto file = std::make_shared<const OpenFile>(path);
    return {.rows = layout->rows, .columns = layout->columns, .read = [file, layout, shape](const MatrixBlock& block) {
              return read_block(*file, *layout, shape, block);
            }};
  }
  return open_matrix(read_matrix(path, shape, variable));
}

DistanceMatrix whole_matrix(const OpenMatrix& matrix) {
  return matrix.read({.first_row = 0, .rows = matrix.rows, .first_column = 0, .columns = matrix.columns});
}

}  // namespace shapegauge
