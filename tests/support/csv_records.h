// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/csv.h"
#include "tests/support/test_files.h"

/// CSV tables that programs write, read back by the names of their columns.
namespace shapegauge::test {

/// Reads a CSV file with a header: one map from column name to cell text per row.
inline std::vector<std::map<std::string, std::string>> csv_records(const std::filesystem::path& file) {
  const std::vector<CsvRow> rows = parse_csv(text_of(file), file.string());
  std::vector<std::map<std::string, std::string>> records;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    auto& record = records.emplace_back();
    for (std::size_t k = 0; k < rows[i].cells.size(); ++k) record[rows[0].cells.at(k)] = rows[i].cells[k];
  }
  return records;
}

/// Returns the only row of a CSV file whose cells equal the pairs (column, text) in `cells`, as a map from column name
/// to cell text. Throws std::out_of_range if no row or several rows match.
inline std::map<std::string, std::string> csv_record(const std::filesystem::path& file,
                                                     std::initializer_list<std::pair<std::string, std::string>> cells) {
  std::vector<std::map<std::string, std::string>> found;
  for (const auto& record : csv_records(file)) {
    bool fits = true;
    for (const auto& [column, text] : cells) fits &= record.at(column) == text;
    if (fits) found.push_back(record);
  }
  if (found.size() != 1) throw std::out_of_range(std::to_string(found.size()) + " rows in " + file.string());
  return found.front();
}

/// Returns the numbers in the named columns of a row (csv_record()), in the order of `columns`.
inline std::vector<double> csv_numbers(const std::map<std::string, std::string>& record,
                                       std::initializer_list<std::string> columns) {
  std::vector<double> numbers;
  for (const std::string& column : columns) numbers.push_back(std::stod(record.at(column)));
  return numbers;
}

}  // namespace shapegauge::test
