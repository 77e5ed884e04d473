#include "shapegauge/experiments/matrices/csv_matrix.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <stdexcept>
#include <unordered_set>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/matrices/number_rows.h"
#include "shapegauge/experiments/text/csv.h"
#include "shapegauge/experiments/text/parse_number.h"
#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {
namespace {

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
  const std::vector<CsvRow> table = parse_csv(text, source);
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
  const std::vector<CsvRow> table = parse_csv(text, source);
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
  return parse_csv_matrix(read_file_bytes(path), path.string());
}

void write_csv_matrix(const std::filesystem::path& path, const LabelledDistances& matrix) {
  const bool has_ids = !matrix.ids.empty();
  if (has_ids && matrix.ids.size() != static_cast<std::size_t>(matrix.distances.rows())) {
    throw std::invalid_argument(
        fmt::format("{} ids for a matrix of {} rows", matrix.ids.size(), matrix.distances.rows()));
  }
  check_ids(matrix.ids, "cannot write " + path.string());
  std::vector<std::string> cells;
  for (const std::string& id : matrix.ids) {
    if (id.find_first_of("\r\n") != std::string::npos) {
      throw InputError(fmt::format("cannot write {}: the id {} contains a line break", path.string(), quoted_word(id)));
    }
    cells.push_back(csv_cell(id));
  }
  std::string text;
  if (has_ids) text = fmt::format("id,{}\n", fmt::join(cells, ","));
  for (Eigen::Index row = 0; row < matrix.distances.rows(); ++row) {
    if (has_ids) text += cells[static_cast<std::size_t>(row)] + ',';
    const auto numbers = matrix.distances.row(row);
    fmt::format_to(std::back_inserter(text), "{}\n", fmt::join(numbers.begin(), numbers.end(), ","));
  }
  write_file_atomically(path, text);
}

}  // namespace shapegauge
