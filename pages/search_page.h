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
  std::string name;
  std::optional<ShapeView> view;  ///< interactive view; absent if the file cannot be read
};

/// Nearest shapes of one query on a search page.
struct SearchPageAnswer {
  std::size_t query = 0;                                ///< index of the query in SearchPage::shapes
  std::vector<std::pair<std::size_t, double>> nearest;  ///< indices in SearchPage::shapes and distances, nearest first
  std::string failure = {};                             ///< reason for a missing answer; empty for none
};

/// Contents of the page of `shapegauge search`.
struct SearchPage {
  std::string title;
  std::vector<std::string> facts;       ///< short texts below the title
  std::vector<SearchPageShape> shapes;  ///< queries and shapes that were found
  std::vector<SearchPageAnswer> answers;
};

/// Renders the page as one self-contained HTML file: pictures of the shapes, and each next to its query in an
/// interactive view. The same content gives the same bytes on any number of threads. Throws as view_page() does.
std::string search_page(const SearchPage& page);

}  // namespace shapegauge
