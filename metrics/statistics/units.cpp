#include "shapegauge/metrics/statistics/units.h"

#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>

#include "shapegauge/metrics/named_values.h"

namespace shapegauge {
namespace {

constexpr std::array all_blocks = {Named<Blocks>{Blocks::classes, "classes"},
                                   Named<Blocks>{Blocks::queries, "queries"}};
constexpr std::array averages = {Named<Average>{Average::micro, "micro"}, Named<Average>{Average::macro, "macro"}};

std::map<int, double> sizes_of(std::span<const int> classes) {
  std::map<int, double> sizes;
  for (const int label : classes) sizes[label] += 1;
  return sizes;
}

Units query_units(const Eigen::MatrixXd& per_query, std::span<const int> classes, Average average) {
  const std::map<int, double> sizes = sizes_of(classes);
  Units units{per_query, Eigen::VectorXd(per_query.rows())};
  for (Eigen::Index row = 0; row < per_query.rows(); ++row) {
    const double size = sizes.at(classes[static_cast<std::size_t>(row)]);
    units.weights[row] = average == Average::micro ? 1.0 : 1.0 / size;
  }
  return units;
}

Units class_units(const Eigen::MatrixXd& per_query, std::span<const int> classes, Average average) {
  const std::map<int, double> sizes = sizes_of(classes);
  std::map<int, Eigen::Index> unit_of_class;
  for (const auto& [label, size] : sizes) unit_of_class.emplace(label, static_cast<Eigen::Index>(unit_of_class.size()));
  const auto count = static_cast<Eigen::Index>(sizes.size());
  Units units{Eigen::MatrixXd::Zero(count, per_query.cols()), Eigen::VectorXd(count)};
  for (Eigen::Index row = 0; row < per_query.rows(); ++row) {
    units.values.row(unit_of_class.at(classes[static_cast<std::size_t>(row)])) += per_query.row(row);
  }
  for (const auto& [label, size] : sizes) {
    const Eigen::Index unit = unit_of_class.at(label);
    units.values.row(unit) /= size;
    units.weights[unit] = average == Average::micro ? size : 1.0;
  }
  return units;
}

}  // namespace

std::string name_of(Blocks blocks) { return name_in<Blocks>(all_blocks, blocks); }
std::optional<Blocks> blocks_of(std::string_view name) { return value_in<Blocks>(all_blocks, name); }
std::vector<std::string> blocks_names() { return names_in<Blocks>(all_blocks); }
std::string name_of(Average average) { return name_in<Average>(averages, average); }
std::optional<Average> average_of(std::string_view name) { return value_in<Average>(averages, name); }
std::vector<std::string> average_names() { return names_in<Average>(averages); }

Units units_of(const Eigen::MatrixXd& per_query, std::span<const int> classes, Blocks blocks, Average average) {
  if (per_query.rows() == 0) throw std::invalid_argument("no queries to make statistics of");
  if (static_cast<std::size_t>(per_query.rows()) != classes.size()) {
    throw std::invalid_argument("values of " + std::to_string(per_query.rows()) + " queries, but classes of " +
                                std::to_string(classes.size()));
  }
  Units units =
      blocks == Blocks::queries ? query_units(per_query, classes, average) : class_units(per_query, classes, average);
  units.weights /= units.weights.sum();
  return units;
}

Eigen::VectorXd averages_of(const Units& units) { return units.values.transpose() * units.weights; }

Eigen::VectorXd contributions(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights) {
  return static_cast<double>(differences.size()) * differences.cwiseProduct(weights);
}

}  // namespace shapegauge
