#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// What the report of a method says beyond its distances; nothing of it for a distance matrix from elsewhere.
struct ReportHistograms {
  const Signatures* table = nullptr;  ///< a histogram a row
  std::vector<Interval> ranges;       ///< of each row's histogram
  std::vector<std::size_t> parts;     ///< instead of a table: methods whose histograms are side by side here
};

/// A method in a report.
struct ReportMethod {
  std::string name;
  std::string description;  ///< its settings, in a few words; may be empty
  const DistanceOverview* distances = nullptr;
  std::span<const Evaluation> evaluations;  ///< one or more, one a protocol; the same protocols for all methods
  ReportHistograms histograms;
};

/// Pictures of the models, all drawn alike.
struct ReportPictures {
  std::vector<std::string> png;  ///< one a model, the bytes of a PNG file; none at all without pictures
  Interval range;                ///< of the values with the ends of the colour map
  std::string field;             ///< what the colours show
};

/// A field that the views of the models show.
struct ViewedField {
  std::string name;
  std::optional<Interval> colours;  ///< the values with the ends of the colour scale; else each model's own
};

/// The models as shapes that one can turn.
struct ReportViews {
  std::vector<ViewedField> fields;  ///< of every view, in its order
  std::vector<std::string>
      shapes;  ///< one a model, as shape_view_json() without names gives them; none at all without views
};

/// All that the report shows. What it points to must outlive it.
struct Report {
  std::string title;
  std::string description;
  std::vector<std::pair<std::string, std::string>> facts;  ///< about all methods: a heading and what is to be said
  std::vector<std::string> classes;                        ///< names, by label
  std::vector<std::string> ids;                            ///< of the models: rows and columns of the matrices
  std::vector<int> labels;                                 ///< of the models
  std::vector<ReportMethod> methods;                       ///< at least one
  ReportPictures pictures;
  ReportViews views;
  std::vector<std::string> warnings;
  std::vector<std::pair<std::string, std::string>> failures;  ///< models left out, and why
};

/// The report as one HTML file that needs nothing else: styles, scripts, data and pictures are in it. The same report
/// gives the same bytes, on any number of threads.
std::string report_page(const Report& report);

}  // namespace shapegauge
