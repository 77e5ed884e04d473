// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/pages/search_page.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge::test_view {

/// Two balls next to each other, of diameter 2 (part 0, value 2) and 0.5 (part 1, value 0.5), with fields, parts and
/// normals at the faces, with a name that needs escaping in markup.
ShapeView balls();

/// Point cloud of 800 points on a sphere of diameter 1, with its diameter as the field.
ShapeView cloud();

/// Both, and the name of a missing shape.
ViewPage page();

/// Search page: a query with three results, the last without a view, and a query without results.
SearchPage sample_search();

}  // namespace shapegauge::test_view
