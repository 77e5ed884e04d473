#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// AUC-PR; see its definition below.
double area_under_curve(const RankedList& list);

inline constexpr MeasureDefinition area_under_curve_definition{
    .name = "AUC-PR",
    .title = "area under the precision-recall curve",
    .definition =
        "The area under straight lines between the points (k / R, precision at the k-th hit), k = 1 to R,"
        " and level from recall 0 to the first point.",
    .source =
        "The curve that psbPlot draws; Davis and Goadrich, The relationship between precision-recall and "
        "ROC curves, ICML 2006.",
    .caveat =
        "Straight lines between the points are optimistic (Davis and Goadrich); mAP is the same area "
        "under steps. A model that is not in the list counts with precision 0.",
    .value = area_under_curve,
};

}  // namespace shapegauge
