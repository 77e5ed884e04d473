// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

/// Shape on a search page, either a query or a shape that was found.
struct SearchPageShape {
  std::string name;               ///< name of the shape
  std::optional<ShapeView> view;  ///< interactive view; absent if the file cannot be read
};

/// Result of one query on a search page: its nearest shapes, or the reason why there are none.
struct SearchPageResult {
  std::size_t query = 0;                                ///< index of the query in SearchPage::shapes
  std::vector<std::pair<std::size_t, double>> nearest;  ///< index in SearchPage::shapes and distance, nearest first
  std::string failure = {};                             ///< reason why the query has no result; empty if it has one
};

/// Contents of the page of `shapegauge search`.
struct SearchPage {
  std::string title;                      ///< title of the page
  std::vector<std::string> facts;         ///< short texts below the title
  std::vector<SearchPageShape> shapes;    ///< queries and found shapes
  std::vector<SearchPageResult> answers;  ///< results, one per query
};

/// Renders the page as one self-contained HTML file: pictures of the shapes, and each next to its query in an
/// interactive view. The same content gives the same bytes on any number of threads. Throws as view_page() does.
std::string search_page(const SearchPage& page);

}  // namespace shapegauge
