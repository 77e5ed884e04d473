#include "shapegauge/datasets/files/matrix_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <tbb/blocked_range.h>
#include <unistd.h>
#include <unordered_set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/datasets/files/mat_file.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

namespace {

// Puts a matrix together from the rows of a text file and refuses what does not fit, with file and line.
class NumberRows {
 public:
  NumberRows(const std::string& source, TableShape shape) : source_(&source), shape_(shape) {}

  // Adds the next number to the row that is being read.
  void add_number(std::string_view word, std::size_t line) {
    const auto number = parse_number(word);
    if (!number) {
      const bool decimal_comma = word.find(',') != std::string_view::npos;
      throw InputError(fmt::format("{}:{}: {} is not a number (number {} of the row){}", *source_, line,
                                   quoted_word(word), numbers_.size() - row_begin_ + 1,
                                   decimal_comma ? "; write decimal points, not commas" : ""));
    }
    numbers_.push_back(*number);
  }

  void end_row(std::size_t line) {
    const std::size_t length = numbers_.size() - row_begin_;
    if (length == 0) throw InputError(fmt::format("{}:{}: the row has no numbers", *source_, line));
    if (rows_ == 0) {
      columns_ = length;
      first_line_ = line;
    }
    if (length != columns_) {
      throw InputError(fmt::format("{}:{}: the row has {} numbers, but the one in line {} has {}", *source_, line,
                                   length, first_line_, columns_));
    }
    if (shape_ == TableShape::square && rows_ == columns_) {
      throw InputError(fmt::format("{}:{}: a distance matrix is square, but this is row {} and rows have {} numbers",
                                   *source_, line, rows_ + 1, columns_));
    }
    ++rows_;
    row_begin_ = numbers_.size();
  }

  [[nodiscard]] DistanceMatrix matrix() const {
    if (rows_ == 0) throw InputError(fmt::format("{}: the file has no numbers", *source_));
    if (shape_ == TableShape::square && rows_ != columns_) {
      throw InputError(
          fmt::format("{}: a distance matrix is square, but the file has {} rows of {} numbers; it may be "
                      "cut off",
                      *source_, rows_, columns_));
    }
    return Eigen::Map<const DistanceMatrix>(numbers_.data(), static_cast<Eigen::Index>(rows_),
                                            static_cast<Eigen::Index>(columns_));
  }

 private:
  const std::string* source_;
  TableShape shape_;
  std::vector<double> numbers_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t first_line_ = 0;
  std::size_t row_begin_ = 0;
};

void check_ids(const std::vector<std::string>& ids, const std::string& where) {
  std::unordered_set<std::string_view> seen;
  for (const std::string& id : ids) {
    if (id.empty()) throw InputError(fmt::format("{}: an id is empty", where));
    if (!seen.insert(id).second) throw InputError(fmt::format("{}: the id {} occurs twice", where, quoted_word(id)));
  }
}

// The ids of the columns, behind the first cell of the header row.
std::vector<std::string> read_ids(const CsvRow& header, const std::string& source) {
  std::vector<std::string> ids(header.cells.begin() + 1, header.cells.end());
  check_ids(ids, fmt::format("{}:{}", source, header.line));
  return ids;
}

void check_row_id(const CsvRow& row, std::size_t index, const std::vector<std::string>& ids,
                  const std::string& source) {
  if (index >= ids.size()) {
    throw InputError(
        fmt::format("{}:{}: there are more rows than the {} ids of the header row", source, row.line, ids.size()));
  }
  if (row.cells.front() == ids[index]) return;
  throw InputError(
      fmt::format("{}:{}: the row is of {}, but the column of the same number is of {}; rows and columns "
                  "must have the same ids in the same order",
                  source, row.line, quoted_word(row.cells.front()), quoted_word(ids[index])));
}

}  // namespace

LabelledDistances parse_csv_matrix(std::string_view text, const std::string& source) {
  const std::vector<CsvRow> table = parse_csv(text, source, number_separator(text));
  LabelledDistances result;
  const bool has_ids = !table.empty() && !parse_number(table.front().cells.front());
  if (has_ids) result.ids = read_ids(table.front(), source);
  const std::size_t first_row = has_ids ? 1 : 0;
  NumberRows rows(source, TableShape::square);
  for (std::size_t i = first_row; i < table.size(); ++i) {
    const CsvRow& row = table[i];
    if (has_ids) check_row_id(row, i - first_row, result.ids, source);
    for (std::size_t j = first_row; j < row.cells.size(); ++j) rows.add_number(row.cells[j], row.line);
    rows.end_row(row.line);
  }
  result.distances = rows.matrix();
  if (has_ids && result.ids.size() != static_cast<std::size_t>(result.distances.cols())) {
    throw InputError(fmt::format("{}: the header row has {} ids, but there are {} rows of {} numbers", source,
                                 result.ids.size(), result.distances.rows(), result.distances.cols()));
  }
  return result;
}

namespace {

bool is_number(const std::string& cell) { return parse_number(cell).has_value(); }

bool names_ids(const std::string& cell) { return cell.empty() || cell == "id"; }

bool has_header(const std::vector<CsvRow>& table) {
  if (table.empty()) return false;
  const std::vector<std::string>& cells = table.front().cells;
  if (is_number(cells.front())) return false;
  return names_ids(cells.front()) || !std::all_of(cells.begin() + 1, cells.end(), is_number);
}

}  // namespace

LabelledTable parse_csv_table(std::string_view text, const std::string& source) {
  const std::vector<CsvRow> table = parse_csv(text, source, number_separator(text));
  const bool header = has_header(table);
  const std::size_t first_row = header ? 1 : 0;
  const bool row_ids = (header && names_ids(table.front().cells.front())) ||
                       (table.size() > first_row && !is_number(table[first_row].cells.front()));
  const std::ptrdiff_t first_column = row_ids ? 1 : 0;
  LabelledTable result;
  NumberRows rows(source, TableShape::any);
  for (std::size_t i = first_row; i < table.size(); ++i) {
    const CsvRow& row = table[i];
    if (row_ids) result.row_ids.push_back(row.cells.front());
    for (auto cell = row.cells.begin() + first_column; cell != row.cells.end(); ++cell)
      rows.add_number(*cell, row.line);
    rows.end_row(row.line);
  }
  result.numbers = rows.matrix();
  check_ids(result.row_ids, source);
  if (!header) return result;
  result.column_ids.assign(table.front().cells.begin() + first_column, table.front().cells.end());
  if (result.column_ids.size() != static_cast<std::size_t>(result.numbers.cols())) {
    throw InputError(fmt::format("{}:{}: the header row has {} names, but the rows have {} numbers", source,
                                 table.front().line, result.column_ids.size(), result.numbers.cols()));
  }
  return result;
}

LabelledDistances read_csv_matrix(const std::filesystem::path& path) {
  return parse_csv_matrix(read_plain_bytes(path), path.string());
}

namespace {

// N where there are exactly N^2 numbers of that many bytes each, and some.
std::optional<Eigen::Index> size_of_square(std::size_t bytes, std::size_t bytes_per_number) {
  const std::size_t numbers = bytes / bytes_per_number;
  const auto size = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(numbers))));
  if (size == 0 || size * size * bytes_per_number != bytes) return std::nullopt;
  return static_cast<Eigen::Index>(size);
}

Eigen::Index psb_matrix_size(std::size_t bytes, const std::string& source) {
  if (const auto size = size_of_square(bytes, sizeof(float))) return *size;
  // 8 N^2 bytes can never be 4 M^2 bytes: the square root of 2 is no fraction.
  if (const auto size_in_doubles = size_of_square(bytes, sizeof(double))) {
    throw InputError(
        fmt::format("{}: {} bytes are no square matrix of float32, which the format has; this looks like "
                    "float64 ({} x {}): convert it, or save it as .npy",
                    source, bytes, *size_in_doubles, *size_in_doubles));
  }
  throw InputError(
      fmt::format("{}: {} bytes are no square matrix of float32 (4 N^2 bytes); the file is cut off or another format",
                  source, bytes));
}

}  // namespace

DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source) {
  const Eigen::Index size = psb_matrix_size(bytes.size(), source);
  DistanceMatrix matrix(size, size);
  float32_format().decode(bytes.data(), static_cast<std::size_t>(matrix.size()), matrix.data());
  return matrix;
}

DistanceMatrix read_psb_matrix(const std::filesystem::path& path) {
  return parse_psb_matrix(read_plain_bytes(path), path.string());
}

namespace {

// The separator of numbers: a semicolon or comma where the line has one, a blank otherwise.
char separator_of_line(std::string_view line) {
  for (const char separator : {';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

void add_numbers(NumberRows& rows, std::string_view line, char separator, std::size_t number) {
  const std::string_view ends = separator == ' ' ? std::string_view(" \t") : std::string_view(&separator, 1);
  while (true) {
    const std::size_t end = line.find_first_of(ends);
    rows.add_number(trim(line.substr(0, end)), number);
    if (end == std::string_view::npos) return;
    line = separator == ' ' ? trim(line.substr(end)) : line.substr(end + 1);
  }
}

}  // namespace

DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source, TableShape shape) {
  NumberRows rows(source, shape);
  std::optional<char> separator;
  std::size_t number = 0;
  for (std::string_view line : split_lines(text)) {
    ++number;
    line = trim(line);
    if (line.empty() || line.starts_with('#')) continue;
    if (!separator) separator = separator_of_line(line);
    add_numbers(rows, line, *separator, number);
    rows.end_row(number);
  }
  return rows.matrix();
}

DistanceMatrix read_text_matrix(const std::filesystem::path& path) {
  return parse_text_matrix(read_plain_bytes(path), path.string());
}

namespace {

DistanceMatrix read_npy(const std::filesystem::path& path) { return parse_npy(read_plain_bytes(path), path.string()); }

template <DistanceMatrix (*read)(const std::filesystem::path&)>
LabelledDistances without_ids(const std::filesystem::path& path) {
  return {.distances = read(path), .ids = {}};
}

LabelledTable npy_table(const std::filesystem::path& path) {
  return {.numbers = parse_npy_table(read_plain_bytes(path), path.string()), .row_ids = {}, .column_ids = {}};
}

DistanceMatrix read_npz(const std::filesystem::path& path) {
  return parse_npy(array_in_npz(read_plain_bytes(path), path.string()), path.string());
}

LabelledTable npz_table(const std::filesystem::path& path) {
  return {.numbers = parse_npy_table(array_in_npz(read_plain_bytes(path), path.string()), path.string()),
          .row_ids = {},
          .column_ids = {}};
}

DistanceMatrix read_square_mat(const std::filesystem::path& path) {
  DistanceMatrix matrix = read_mat(path);
  if (matrix.rows() == matrix.cols()) return matrix;
  throw InputError(fmt::format("{}: a distance matrix is square, but this one is {} x {}", path.string(), matrix.rows(),
                               matrix.cols()));
}

LabelledTable mat_table(const std::filesystem::path& path) {
  return {.numbers = read_mat(path), .row_ids = {}, .column_ids = {}};
}

LabelledTable text_table(const std::filesystem::path& path) {
  return {.numbers = parse_text_matrix(read_plain_bytes(path), path.string(), TableShape::any),
          .row_ids = {},
          .column_ids = {}};
}

LabelledTable csv_table(const std::filesystem::path& path) {
  return parse_csv_table(read_plain_bytes(path), path.string());
}

LabelledTable psb_table(const std::filesystem::path& path) {
  return {.numbers = read_psb_matrix(path), .row_ids = {}, .column_ids = {}};  // knows square ones only
}

struct Format {
  std::string_view extension;
  LabelledDistances (*read)(const std::filesystem::path&);
  LabelledTable (*read_table)(const std::filesystem::path&);
};

constexpr std::array formats = {
    Format{".matrix", without_ids<read_psb_matrix>, psb_table},
    Format{".npy", without_ids<read_npy>, npy_table},
    Format{".npz", without_ids<read_npz>, npz_table},
    Format{".mat", without_ids<read_square_mat>, mat_table},
    Format{".csv", read_csv_matrix, csv_table},
    Format{".tsv", read_csv_matrix, csv_table},
    Format{".txt", without_ids<read_text_matrix>, text_table},
    Format{".dat", without_ids<read_text_matrix>, text_table},
};

const Format& format_of(const std::filesystem::path& path) {
  const auto* const found = std::ranges::find(formats, format_extension(path), &Format::extension);
  if (found != formats.end()) return *found;
  std::string known;
  for (const Format& format : formats) known.append(known.empty() ? "" : ", ").append(format.extension);
  throw InputError(fmt::format("{}: the extension does not tell the format of a distance matrix; known are {}",
                               path.string(), known));
}

struct MatrixPlace {
  Eigen::Index row = 0;
  Eigen::Index column = 0;
};

// `first`: the place in the whole matrix of the first of the numbers.
void refuse_nan(const DistanceMatrix& numbers, const MatrixPlace& first, std::string_view what,
                const std::filesystem::path& path) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (!std::isnan(numbers.data()[i])) continue;
    throw InputError(fmt::format("{}: the {} in row {}, column {} (counted from 0) is not a number (NaN)",
                                 path.string(), what, first.row + i / numbers.cols(),
                                 first.column + i % numbers.cols()));
  }
}

}  // namespace

LabelledDistances read_distance_matrix(const std::filesystem::path& path) {
  LabelledDistances result = format_of(path).read(path);
  refuse_nan(result.distances, {}, "distance", path);
  return result;
}

LabelledTable read_number_table(const std::filesystem::path& path) {
  LabelledTable result = format_of(path).read_table(path);
  refuse_nan(result.numbers, {}, "number", path);
  return result;
}

namespace {

// A file whose bytes are read at any place.
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
      if (count == 0) throw InputError(fmt::format("{}: the file became shorter while it was read", path_.string()));
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

DistanceMatrix read_block(const OpenFile& file, const NpyTable& table, const MatrixBlock& block) {
  DistanceMatrix numbers(block.rows, block.columns);
  const auto row_bytes = static_cast<std::size_t>(block.columns) * table.numbers.bytes;
  parallel_for_parts(
      tbb::blocked_range<Eigen::Index>(0, block.rows), [&](const tbb::blocked_range<Eigen::Index>& some) {
        std::vector<char> bytes(row_bytes);
        for (Eigen::Index row = some.begin(); row < some.end(); ++row) {
          const Eigen::Index entry = (block.first_row + row) * table.columns + block.first_column;
          file.read(bytes, table.data_begin + static_cast<std::size_t>(entry) * table.numbers.bytes);
          table.numbers.decode(bytes.data(), static_cast<std::size_t>(block.columns), numbers.row(row).data());
        }
      });
  refuse_nan(numbers, {block.first_row, block.first_column}, "distance", file.path());
  return numbers;
}

// How a file is read by blocks; nothing where it cannot be.
std::optional<NpyTable> block_layout(const std::filesystem::path& path, TableShape shape) {
  const std::string extension = lower_case(path.extension().string());
  const bool psb = extension == ".matrix";
  if ((!psb && extension != ".npy") || !std::filesystem::is_regular_file(path)) return std::nullopt;
  const auto bytes = static_cast<std::size_t>(std::filesystem::file_size(path));
  constexpr std::size_t longest_usual_header = 1 << 17;
  const std::string beginning = read_file_bytes(path, longest_usual_header);  // refuses what is empty or unreadable
  if (psb) {
    const Eigen::Index size = psb_matrix_size(bytes, path.string());
    return NpyTable{.rows = size, .columns = size, .numbers = float32_format()};
  }
  const NpyTable table = parse_npy_table_header(beginning, bytes, shape == TableShape::square, path.string());
  if (table.column_by_column) return std::nullopt;
  return table;
}

}  // namespace

void write_distance_matrix(const std::filesystem::path& path, const LabelledDistances& matrix) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".npy") return write_npy(path, matrix.distances);
  if (extension != ".csv") {
    throw InputError(fmt::format("distances are written as .npy or .csv, not to \"{}\"", path.string()));
  }
  Table table{.header = {"id"}, .rows = {}};
  for (Eigen::Index i = 0; i < matrix.distances.rows(); ++i) {
    const std::string id = matrix.ids.empty() ? std::to_string(i) : matrix.ids[static_cast<std::size_t>(i)];
    table.header.push_back(id);
    auto& row = table.rows.emplace_back(std::vector{id});
    for (const double distance : matrix.distances.row(i)) row.push_back(fmt::format("{}", distance));
  }
  write_file_atomically(path, to_csv(table));
}

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

OpenMatrix open_matrix(const std::filesystem::path& path, TableShape shape) {
  if (const auto layout = block_layout(path, shape)) {
    const auto file = std::make_shared<const OpenFile>(path);
    return {.rows = layout->rows, .columns = layout->columns, .read = [file, layout](const MatrixBlock& block) {
              return read_block(*file, *layout, block);
            }};
  }
  if (shape == TableShape::any) return open_matrix(read_number_table(path));
  LabelledDistances square = read_distance_matrix(path);
  return open_matrix({.numbers = std::move(square.distances), .row_ids = square.ids, .column_ids = square.ids});
}

DistanceMatrix whole_matrix(const OpenMatrix& matrix) {
  return matrix.read({.first_row = 0, .rows = matrix.rows, .first_column = 0, .columns = matrix.columns});
}

}  // namespace shapegauge
