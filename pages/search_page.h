#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

/// A shape on the page of a search.
struct SearchPageShape {
  std::string name;
  std::optional<ShapeView> view;  ///< none: its file cannot be read
};

/// The answer to one query.
struct SearchPageAnswer {
  std::size_t query = 0;                                ///< index of its shape
  std::vector<std::pair<std::size_t, double>> nearest;  ///< shapes and their distances, nearest first
  std::string failure = {};                             ///< why there is no answer; empty where there is
};

/// The page of `shapegauge search`.
struct SearchPage {
  std::string title;
  std::vector<std::string> facts;  ///< a few words each, below the title
  std::vector<SearchPageShape> shapes;
  std::vector<SearchPageAnswer> answers;
};

/// The page as one HTML file that needs nothing else: pictures of the shapes, and each beside its query, to be turned.
/// The same content gives the same bytes, on any number of threads. Throws as view_page() does.
std::string search_page(const SearchPage& page);

}  // namespace shapegauge
