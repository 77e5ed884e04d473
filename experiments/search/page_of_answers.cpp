// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/search/page_of_answers.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/signatures/model_view.h"
#include "shapegauge/pages/coarse_view.h"
#include "shapegauge/pages/search_page.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// A page of answers has fewer shapes than a report.
constexpr ViewFaces view_faces{.max_total = 600'000, .fewest = 600, .most = 6000};

/// Adds the thickness at the vertices of a shape, if it is defined.
void add_thickness(ShapeView& view) {
  const Samples samples = sample_shape(view.shape, view.site);
  FieldSource source(view.shape);
  FieldSettings settings = field_settings("offset_sdf");
  settings.values.set("offset", std::string_view("auto"));
  FieldValues computed = make_field(std::move(settings)).compute(source, samples, false);
  const auto range = central_range({.values = computed.values, .weights = samples.weights});
  if (!range) return;
  view.fields.push_back({.name = "Thickness", .values = std::move(computed.values), .colours = *range});
}

ShapeView view_of(const Shape& shape, const ShapeDrawing& drawing) {
  ShapeView view{.name = "",
                 .shape = coarse_shape(prepare_shape(shape, {}).shape, drawing.faces),
                 .site = SampleSite::vertices,
                 .up = drawing.up};
  try {
    add_thickness(view);
  } catch (const InputError&) {
    view.fields.clear();  // shown in one colour
  }
  return view;
}

/// Shapes of a page, without repetition.
class PageShapes {
 public:
  PageShapes(const OpenIndex& index, UpAxis up) : index_(&index), up_(up) {}

  std::size_t add_model(std::size_t model) {
    const auto [entry, is_new] = indices_.try_emplace(model, shapes_.size());
    if (!is_new) return entry->second;
    const IndexedFile& file = index_->contents.models[model];
    shapes_.push_back({.name = file.id, .file = index_->collection.file(file.path)});
    return entry->second;
  }

  std::size_t add_query(const SearchQuery& query) {
    shapes_.push_back(query);
    if (!query.file.empty()) shapes_.back().name = query.file.filename().string();
    return shapes_.size() - 1;
  }

  [[nodiscard]] std::vector<SearchPageShape> drawn(const RunControl& control) const {
    std::vector<SearchPageShape> drawn(shapes_.size());
    std::vector<std::size_t> all(shapes_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const Eigen::Index faces = faces_of_views(shapes_.size(), view_faces);
    for (std::size_t i = 0; i < shapes_.size(); ++i) drawn[i].name = shapes_[i].name;
    for_each_model(all, "pictures", false, control, [&](std::size_t i) {
      const SearchQuery& one = shapes_[i];
      drawn[i].view =
          view_of(one.shape ? *one.shape : read_shape(one.file), {.faces = faces, .up = up_direction(up_, one.file)});
    });  // one that fails has no picture
    return drawn;
  }

 private:
  const OpenIndex* index_;
  UpAxis up_;
  std::vector<SearchQuery> shapes_;
  std::map<std::size_t, std::size_t> indices_;  ///< per model: index of its shape
};

}  // namespace

std::string page_of_answers(const OpenIndex& index, std::span<const SearchQuery> queries,
                            std::span<const SearchAnswer> answers, const std::string& title, UpAxis up,
                            const RunControl& control) {
  PageShapes shapes(index, up);
  SearchPage page{.title = title, .facts = {}, .shapes = {}, .answers = {}};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const SearchAnswer& answer = answers[i];
    SearchPageResult& shown = page.answers.emplace_back();
    shown.query = answer.member ? shapes.add_model(*answer.member) : shapes.add_query(queries[i]);
    shown.failure = answer.failure;
    const double unit = answer.median > 0 ? answer.median : 1;
    for (const RankedModel& one : answer.nearest) {
      shown.nearest.emplace_back(shapes.add_model(static_cast<std::size_t>(one.model)), one.distance / unit);
    }
  }
  page.facts = {count_text(std::ssize(answers), "query", "queries"),
                count_text(std::ssize(index.contents.models), "shape", "shapes") + " in the collection",
                fmt::format("compared by \u201c{}\u201d", index.method.name)};
  if (std::ranges::any_of(answers, [](const SearchAnswer& answer) { return answer.median > 0; })) {
    page.facts.emplace_back("distances divided by their median over the collection");
  }
  std::string html;
  with_threads(control, [&] {
    page.shapes = shapes.drawn(control);
    html = search_page(page);
  });
  return html;
}

}  // namespace shapegauge
