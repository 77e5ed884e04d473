// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/report_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "shapegauge/core/version.h"
#include "shapegauge/metrics/retrieval_failures.h"
#include "shapegauge/pages/collection_map.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/packed_numbers.h"
#include "shapegauge/pages/score_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t worst_count = 20;
constexpr int distance_digits = 5;

/// Returns the positions of the queries with the lowest average precision, or first measure if that is missing.
std::vector<std::size_t> worst_of(const Evaluation& evaluation) {
  const bool has_map = std::ranges::find(evaluation.measures, "mAP") != evaluation.measures.end();
  return worst_queries(evaluation, has_map ? "mAP" : evaluation.measures.front(), worst_count);
}

Json intervals_json(const std::vector<ConfidenceInterval>& intervals) {
  Json json = Json::array();
  for (const ConfidenceInterval& one : intervals) {
    json.push_back({rounded_to_digits(one.low, score_digits), rounded_to_digits(one.high, score_digits)});
  }
  return json;
}

Json intervals_json(const EvaluationIntervals& intervals) {
  if (intervals.micro.empty()) return nullptr;
  return {{"confidence", intervals.confidence},
          {"micro", intervals_json(intervals.micro)},
          {"macro", intervals_json(intervals.macro)}};
}

Json page_data_of_evaluation(const Evaluation& evaluation) {
  Json json = chart_data_json(evaluation);
  json["left_out"] = evaluation.excluded_models;
  json["queries"] = evaluation.queries;
  json["per_query"] = rounded_rows(evaluation.per_query);
  json["worst"] = worst_of(evaluation);
  return json;
}

/// Returns the models whose nearest ones are listed, ascending.
std::vector<Eigen::Index> models_with_neighbours(const Report& report, const ReportMethod& method) {
  std::set<Eigen::Index> models;
  if (report.ids.size() <= max_models_with_neighbours) {
    for (std::size_t i = 0; i < report.ids.size(); ++i) models.insert(static_cast<Eigen::Index>(i));
  }
  for (const Evaluation& evaluation : method.evaluations) {
    for (const std::size_t i : worst_of(evaluation)) models.insert(evaluation.queries[i]);
  }
  return {models.begin(), models.end()};
}

/// Lists the nearest models of each of those at finite distances, with these.
Json neighbours_json(const Report& report, const ReportMethod& method) {
  const std::vector<Eigen::Index> models = models_with_neighbours(report, method);
  std::vector<std::vector<std::int32_t>> lists;
  Json distances = Json::array();
  for (const Eigen::Index model : models) {
    std::vector<std::int32_t>& list = lists.emplace_back();
    Json& row = distances.emplace_back(Json::array());
    for (Eigen::Index k = 0; k < method.distances->nearest.cols(); ++k) {
      const double distance = method.distances->nearest_distances(model, k);
      if (!std::isfinite(distance)) break;
      list.push_back(method.distances->nearest(model, k));
      row.push_back(rounded_to_digits(distance, distance_digits));
    }
  }
  return {{"models", models}, {"lists", lists}, {"distances", std::move(distances)}};
}

Json confusion_json(const Report& report, const ReportMethod& method) {
  const Eigen::Matrix<std::int32_t, Eigen::Dynamic, 1> nearest = method.distances->nearest.col(0);
  std::vector<Eigen::Index> queries = method.evaluations.front().queries;
  std::erase_if(queries,
                [&](Eigen::Index query) { return !std::isfinite(method.distances->nearest_distances(query, 0)); });
  const Eigen::MatrixXi counts = confusion_matrix({nearest.data(), static_cast<std::size_t>(nearest.size())},
                                                  report.labels, queries, static_cast<int>(report.classes.size()));
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < counts.rows(); ++row) {
    // Only non-zero entries, as pairs of class and number: a large matrix is sparse.
    Json& entries = rows.emplace_back(Json::array());
    for (Eigen::Index column = 0; column < counts.cols(); ++column) {
      if (counts(row, column) > 0) entries.push_back({column, counts(row, column)});
    }
  }
  return rows;
}

Json histograms_json(const ReportHistograms& histograms) {
  if (histograms.table == nullptr) return nullptr;
  const Eigen::VectorXd values = histograms.table->reshaped<Eigen::RowMajor>().cast<double>();
  Json json = packed_numbers(values);
  json["bins"] = histograms.table->cols();
  json["ranges"] = Json::array();
  for (const Interval& range : histograms.ranges) {
    json["ranges"].push_back(
        {rounded_to_digits(range.low, distance_digits), rounded_to_digits(range.high, distance_digits)});
  }
  return json;
}

/// Encodes the positions of the models in the plane, in the order of the heat map; null for blocks of models.
Json map_json(const DistanceOverview& distances) {
  constexpr int map_digits = 4;
  if (distances.block > 1) return nullptr;
  Json rows = Json::array();
  const Eigen::MatrixX2d positions = plane_embedding(distances.cells);
  for (const auto& position : positions.rowwise()) {
    rows.push_back(
        {rounded_to_digits(position[0], map_digits), rounded_to_digits(position[1], map_digits)});  // null: none
  }
  return rows;
}

Json method_json(const Report& report, const ReportMethod& method) {
  Json evaluations = Json::array();
  for (const Evaluation& evaluation : method.evaluations) evaluations.push_back(page_data_of_evaluation(evaluation));
  for (std::size_t i = 0; i < method.intervals.size(); ++i) {
    evaluations[i]["intervals"] = intervals_json(method.intervals[i]);
  }
  return {{"name", method.name},
          {"distance", method.distance},
          {"settings", method.settings},
          {"evaluations", std::move(evaluations)},
          {"heat_map", heat_map(*method.distances)},
          {"map", map_json(*method.distances)},
          {"confusion", confusion_json(report, method)},
          {"nearest", neighbours_json(report, method)},
          {"histograms", histograms_json(method.histograms)},
          {"parts", method.histograms.parts},
          {"failures", method.failures}};
}

Json pictures_json(const ReportPictures& pictures) {
  if (pictures.png.empty()) return nullptr;
  Json images = Json::array();
  for (const std::string& png : pictures.png) images.push_back(base64(png));
  return {{"field", pictures.field},
          {"low", pictures.range.low},
          {"high", pictures.range.high},
          {"png", std::move(images)}};
}

Json views_json(const ReportViews& views) {
  if (views.shapes.empty()) return nullptr;
  Json fields = Json::array();
  for (const ViewedField& field : views.fields) {
    Json& json = fields.emplace_back(Json{{"name", field.name}});
    if (!field.measured_by.empty()) json["measured"] = {{"by", field.measured_by}, {"unit", 1}};
    if (field.colours) json["colours"] = {{"from", field.colours->low}, {"to", field.colours->high}, {"root", true}};
  }
  Json shapes = Json::array();
  for (const std::string& shape : views.shapes) shapes.push_back(Json::parse(shape));
  return {{"fields", std::move(fields)}, {"shapes", std::move(shapes)}};
}

}  // namespace

Json packed_numbers(const Eigen::Ref<const Eigen::VectorXd>& values) {
  double scale = 0;
  for (const double value : values) {
    if (std::isfinite(value)) scale = std::max(scale, value);
  }
  if (!(scale > 0)) scale = 1;
  return {{"scale", scale}, {"values", packed_values(values, 0, scale)}};
}

Json heat_map(const DistanceOverview& distances) {
  const Eigen::MatrixXd& cells = distances.cells;
  const Eigen::Index side = cells.rows();
  const bool symmetric = cells == cells.transpose();
  std::vector<double> values;
  for (Eigen::Index row = 0; row < side; ++row) {
    for (Eigen::Index column = symmetric ? row : 0; column < side; ++column) values.push_back(cells(row, column));
  }
  Json json{{"side", side}, {"block", distances.block}, {"symmetric", symmetric}};
  json.update(
      packed_numbers(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))));
  return json;
}

Json report_json(const Report& report) {
  Json methods = Json::array();
  for (const ReportMethod& method : report.methods) methods.push_back(method_json(report, method));
  Json leaks = Json::array();
  for (const ReportLeak& leak : report.leaks) {
    leaks.push_back(
        {leak.id, leak.field, rounded_to_digits(leak.offset, score_digits), rounded_to_digits(leak.gap, score_digits)});
  }
  return {{"version", version()},
          {"title", report.title},
          {"description", report.description},
          {"facts", report.facts},
          {"classes", report.classes},
          {"ids", report.ids},
          {"labels", report.labels},
          {"methods", std::move(methods)},
          {"tests", {{"words", report.tests.words}, {"pairs", table_json(report.tests.pairs)}}},
          {"pictures", pictures_json(report.pictures)},
          {"views", views_json(report.views)},
          {"perturbations", report.perturbations},
          {"warnings", report.warnings},
          {"leaks", std::move(leaks)},
          {"failures", report.failures}};
}

}  // namespace shapegauge
