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

/// Histograms of a method in a report; empty for an imported distance matrix.
struct ReportHistograms {
  const Signatures* table = nullptr;  ///< histograms of the models, one per row; null for none
  std::vector<Interval> ranges;       ///< range of values of each row's histogram
  std::vector<std::size_t> parts;     ///< indices of methods whose histograms this method concatenates
};

/// Settings as pairs of name and value.
using ReportSettings = std::vector<std::pair<std::string, std::string>>;

/// Method in a report: its settings, distances, evaluations, histograms and failures.
struct ReportMethod {
  std::string name;
  std::string distance;     ///< name of the distance between features; may be empty
  ReportSettings settings;  ///< settings of the method; may be empty
  const DistanceOverview* distances = nullptr;
  std::span<const Evaluation> evaluations;     ///< one per protocol, at least one; all methods have the same protocols
  std::vector<EvaluationIntervals> intervals;  ///< confidence intervals, one entry per evaluation; may be empty
  ReportHistograms histograms;
  std::vector<std::pair<std::string, std::string>> failures =
      {};  ///< ids of models that the method cannot process, and the reasons
};

/// Pictures of the models, all with the same settings.
struct ReportPictures {
  std::vector<std::string> png;  ///< bytes of a PNG file per model; empty without pictures
  Interval range;                ///< field values at the ends of the colour map
  std::string field;             ///< name of the field that the colours show
};

/// Field shown by the views of the models.
struct ViewedField {
  std::string name;
  std::optional<Interval> colours;  ///< values at the ends of the colour scale; if absent, each model has its own scale
  std::string measured_by = {};     ///< what its values are lengths of, see measured_by(); empty for none
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
  double offset = 0;  ///< offset of the field
  double gap = 0;     ///< offset that would close the gaps
};

/// Pairwise comparison of the methods by significance tests.
struct ReportTests {
  TextTable pairs;    ///< table of pairs of methods; may have no rows
  std::string words;  ///< explanation of the table `pairs`
};

/// Contents of a report. Everything it points to must outlive it.
struct Report {
  std::string title;
  std::string description;
  std::vector<std::pair<std::string, std::string>> facts;  ///< facts about the experiment: headings and texts
  std::vector<std::string> classes;                        ///< names of the classes, indexed by label
  std::vector<std::string> ids;       ///< ids of the models, in the order of matrix rows and columns
  std::vector<int> labels;            ///< class label of each model
  std::vector<ReportMethod> methods;  ///< compared methods, at least one
  ReportTests tests;
  ReportPictures pictures;
  ReportViews views;
  std::vector<std::pair<std::string, ReportSettings>> perturbations;  ///< steps of perturbation: type and settings
  std::vector<std::string> warnings;
  std::vector<ReportLeak> leaks;
  std::vector<std::pair<std::string, std::string>> failures;  ///< ids of omitted models and the reasons
};

/// Renders the report as one self-contained HTML file with embedded styles, scripts, data and pictures. The same report
/// gives the same bytes on any number of threads.
std::string report_page(const Report& report);

}  // namespace shapegauge
