// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/experiments/search/search.h"

namespace shapegauge {

/// Renders an HTML page with queries and their answers (search_page()). Each query and each result is read from its
/// file, scaled to unit area, simplified, and coloured by its thickness (offset SDF). A shape whose file cannot be read
/// has no picture. `up` is the vertical axis. Throws Interrupted.
std::string page_of_answers(const OpenIndex& index, std::span<const SearchQuery> queries,
                            std::span<const SearchAnswer> answers, const std::string& title, UpAxis up,
                            const RunControl& control);

}  // namespace shapegauge
