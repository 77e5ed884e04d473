#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// BEP; see its definition below.
double bulls_eye(const RankedList& list);

inline constexpr MeasureDefinition bulls_eye_definition{
    .name = "BEP",
    .title = "bull's eye score",
    .definition =
        "The share of the query's class, the query included, among the first 2C ranks of a list that "
        "begins with the query, C = R + 1: (1 + sum of h(1) to h(2C - 1)) / C.",
    .source =
        "Latecki, Lakamper, Eckhardt, Shape descriptors for non-rigid shapes with a single closed "
        "contour, CVPR 2000 (MPEG-7 part B).",
    .caveat =
        "The query finds itself and counts, under every protocol; for classes of two it is 0.5 at least. "
        "Under paper the same as ST.",
    .value = bulls_eye,
};

}  // namespace shapegauge
