// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

/// Shape on a search page.
struct SearchPageShape {
  std::string name;
  std::optional<ShapeView> view;  ///< absent if the file cannot be read
};

/// Answer to one query.
struct SearchPageAnswer {
  std::size_t query = 0;                                ///< index of its shape
  std::vector<std::pair<std::size_t, double>> nearest;  ///< shapes and their distances, nearest first
  std::string failure = {};                             ///< reason for a missing answer; otherwise empty
};

/// Page of `shapegauge search`.
struct SearchPage {
  std::string title;
  std::vector<std::string> facts;  ///< short texts below the title
  std::vector<SearchPageShape> shapes;
  std::vector<SearchPageAnswer> answers;
};

/// Renders the page as one self-contained HTML file: pictures of the shapes, and each next to its query in an
/// interactive view. The same content gives the same bytes on any number of threads. Throws as view_page() does.
std::string search_page(const SearchPage& page);

}  // namespace shapegauge
