#include "shapegauge/experiments/datasets/csv_layout.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/datasets/natural_order.h"
#include "shapegauge/experiments/text/csv.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Position of a column by its name in the first row.
std::size_t column(const CsvRow& header, const std::string& name, const std::string& source) {
  const auto found = std::ranges::find(header.cells, name);
  if (found == header.cells.end()) {
    throw InputError(fmt::format("{}:{}: the first row must name the columns id, path and class; there is no \"{}\"",
                                 source, header.line, name));
  }
  return static_cast<std::size_t>(found - header.cells.begin());
}

const std::string& cell(const CsvRow& row, std::size_t position, const std::string& name, const std::string& source) {
  if (row.cells[position].empty()) throw InputError(fmt::format("{}:{}: the {} is empty", source, row.line, name));
  return row.cells[position];
}

/// The number of a class, a new one where the name is new.
int label_of(const std::string& name, Dataset& dataset) {
  const auto found = std::ranges::find(dataset.classes, name);
  const auto label = static_cast<int>(found - dataset.classes.begin());
  if (found == dataset.classes.end()) dataset.classes.push_back(name);
  return label;
}

}  // namespace

Dataset find_csv_dataset(const DatasetLocation& location) {
  const std::string source = location.classification.string();
  const std::vector<CsvRow> rows = parse_csv(read_file_bytes(location.classification), source);
  if (rows.size() < 2) throw InputError(fmt::format("{}: no models; expected rows id,path,class", source));
  const std::size_t id = column(rows[0], "id", source);
  const std::size_t path = column(rows[0], "path", source);
  const std::size_t name = column(rows[0], "class", source);

  Dataset dataset;
  std::map<std::string, std::size_t> lines;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    if (row.cells.size() != rows[0].cells.size()) {
      throw InputError(fmt::format("{}:{}: {} cells where the first row has {}", source, row.line, row.cells.size(),
                                   rows[0].cells.size()));
    }
    Model model{.id = cell(row, id, "id", source),
                .file = location.root / cell(row, path, "path", source),
                .label = label_of(cell(row, name, "class", source), dataset)};
    const auto [earlier, added] = lines.emplace(model.id, row.line);
    if (!added) {
      throw InputError(
          fmt::format("{}:{}: the model {} stands in line {} already", source, row.line, model.id, earlier->second));
    }
    dataset.models.push_back(std::move(model));
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

}  // namespace shapegauge
