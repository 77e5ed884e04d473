#pragma once

#include "shapegauge/pages/search_page.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge::test_view {

/// Two balls beside each other, of diameter 2 (part 0, value 2) and 0.5 (part 1, value 0.5), with fields, parts and
/// normals at the faces, under a name that a page of markup could trip over.
ShapeView balls();

/// A cloud of 800 points on a sphere of diameter 1, with that as the value of its field.
ShapeView cloud();

/// Both, and a name of a shape that is missing.
ViewPage page();

/// The page of a search: one answer of three shapes, of which the last has no view, and a query without an answer.
SearchPage sample_search();

}  // namespace shapegauge::test_view
