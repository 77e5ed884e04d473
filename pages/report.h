// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// Histograms of a method in a report; empty for a distance matrix from elsewhere.
struct ReportHistograms {
  const Signatures* table = nullptr;  ///< one histogram per row
  std::vector<Interval> ranges;       ///< per row: range of the histogram
  std::vector<std::size_t> parts;     ///< instead of a table: methods whose histograms are concatenated
};

/// Settings by name.
using ReportSettings = std::vector<std::pair<std::string, std::string>>;

/// Method in a report.
struct ReportMethod {
  std::string name;
  std::string distance;     ///< name of the distance; may be empty
  ReportSettings settings;  ///< may be empty
  const DistanceOverview* distances = nullptr;
  std::span<const Evaluation> evaluations;     ///< one per protocol, at least one; the same protocols for all methods
  std::vector<EvaluationIntervals> intervals;  ///< one per evaluation; may be empty
  ReportHistograms histograms;
  std::vector<std::pair<std::string, std::string>> failures =
      {};  ///< models that the method cannot process, and the reasons
};

/// Pictures of the models, all with the same settings.
struct ReportPictures {
  std::vector<std::string> png;  ///< one per model, the bytes of a PNG file; empty without pictures
  Interval range;                ///< values at the ends of the colour map
  std::string field;             ///< field that the colours show
};

/// Field shown by the views of the models.
struct ViewedField {
  std::string name;
  std::optional<Interval> colours;  ///< values at the ends of the colour scale; if absent, each model's own
  std::string measured_by = {};     ///< measured_by() of its type
};

/// Interactive 3D views of the models.
struct ReportViews {
  std::vector<ViewedField> fields;  ///< of every view, in order
  std::vector<std::string>
      shapes;  ///< one per model, as shape_view_json() returns them, without names; empty without views
};

/// Shape with gaps that are wider than the offset of a field. Sizes are fractions of the bounding box diagonal.
struct ReportLeak {
  std::string id;
  std::string field;
  double offset = 0;
  double gap = 0;  ///< offset that closes the gaps
};

/// Comparison of the methods in pairs.
struct ReportTests {
  TextTable pairs;    ///< may have no rows
  std::string words;  ///< explains the table
};

/// Contents of a report. Everything it points to must outlive it.
struct Report {
  std::string title;
  std::string description;
  std::vector<std::pair<std::string, std::string>> facts;  ///< headings and texts about all methods
  std::vector<std::string> classes;                        ///< names, by label
  std::vector<std::string> ids;                            ///< of the models: rows and columns of the matrices
  std::vector<int> labels;                                 ///< of the models
  std::vector<ReportMethod> methods;                       ///< at least one
  ReportTests tests;
  ReportPictures pictures;
  ReportViews views;
  std::vector<std::pair<std::string, ReportSettings>> perturbations;  ///< type and settings, in order
  std::vector<std::string> warnings;
  std::vector<ReportLeak> leaks;
  std::vector<std::pair<std::string, std::string>> failures;  ///< omitted models and the reasons
};

/// Renders the report as one self-contained HTML file with embedded styles, scripts, data and pictures. The same report
/// gives the same bytes on any number of threads.
std::string report_page(const Report& report);

}  // namespace shapegauge
