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

/// Histograms of a method in a report; `table` is null for other methods, such as imported distance matrices.
struct ReportHistograms {
  const Signatures* table = nullptr;  ///< histograms of the models, one per row; null for none
  std::vector<Interval> ranges;       ///< range of the field's values that each row's histogram covers
  std::vector<std::size_t> parts;     ///< indices in Report::methods of those whose histograms this one concatenates
};

/// Settings as pairs of name and value.
using ReportSettings = std::vector<std::pair<std::string, std::string>>;

/// Method in a report: its settings, distances, evaluations, histograms and failures.
struct ReportMethod {
  std::string name;
  std::string distance;                         ///< name of the distance between features; empty if unknown
  ReportSettings settings;                      ///< settings of the method; empty if unknown
  const DistanceOverview* distances = nullptr;  ///< overview of the distance matrix; never null
  std::span<const Evaluation> evaluations;      ///< scores, one per protocol, at least one; same protocols for all
  std::vector<EvaluationIntervals> intervals;   ///< confidence intervals, one per evaluation; empty if not computed
  ReportHistograms histograms;                  ///< histograms of the models by this method
  std::vector<std::pair<std::string, std::string>> failures =
      {};  ///< ids of models that the method cannot process, and the reasons
};

/// Pictures of the models in a report, all with the same colour map.
struct ReportPictures {
  std::vector<std::string> png;  ///< bytes of a PNG file per model; empty without pictures
  Interval range;                ///< field values at the ends of the colour map
  std::string field;             ///< name of the field that the colours show
};

/// Scalar field that the interactive views of the models show.
struct ViewedField {
  std::string name;
  std::optional<Interval> colours;  ///< values at the ends of the colour scale; if absent, each model has its own scale
  std::string measured_by = {};     ///< measured object: "ray", "ball" or "gap", see measured_by(); empty for none
};

/// Interactive 3D views of the models.
struct ReportViews {
  std::vector<ViewedField> fields;  ///< fields that every view has, in the order of the views
  std::vector<std::string>
      shapes;  ///< JSON of each model's view (shape_view_json()), without field names; empty without views
};

/// Shape with gaps too wide to be closed by the offset surface of a field. Sizes are fractions of the bounding box
/// diagonal.
struct ReportLeak {
  std::string id;     ///< id of the model
  std::string field;  ///< settings of the field as text
  double offset = 0;  ///< offset distance of the field, in bounding-box diagonals
  double gap = 0;     ///< radius of the widest gap, in bounding-box diagonals
};

/// Pairwise comparison of the methods by significance tests.
struct ReportTests {
  TextTable pairs;    ///< table with one row per pair of methods; no rows without tests
  std::string words;  ///< explanation of the table `pairs`
};

/// Contents of the report of a retrieval experiment. Everything it points to must outlive it.
struct Report {
  std::string title;                                       ///< title of the report
  std::string description;                                 ///< description of the experiment; empty if there is none
  std::vector<std::pair<std::string, std::string>> facts;  ///< facts about the experiment: headings and texts
  std::vector<std::string> classes;                        ///< names of the classes
  std::vector<std::string> ids;       ///< ids of the models, in the order of matrix rows and columns
  std::vector<int> labels;            ///< index in `classes` of the class of each model
  std::vector<ReportMethod> methods;  ///< compared methods, at least one
  ReportTests tests;                  ///< significance tests between methods
  ReportPictures pictures;            ///< pictures of the models
  ReportViews views;                  ///< interactive views of the models
  std::vector<std::pair<std::string, ReportSettings>> perturbations;  ///< perturbation steps: type and settings
  std::vector<std::string> warnings;                                  ///< warnings about the experiment
  std::vector<ReportLeak> leaks;                                      ///< shapes with gaps that the offsets leave open
  std::vector<std::pair<std::string, std::string>> failures;          ///< ids of omitted models and the reasons
};

/// Renders the report as one self-contained HTML file with embedded styles, scripts, data and pictures. The same report
/// gives the same bytes on any number of threads.
std::string report_page(const Report& report);

}  // namespace shapegauge
