#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numeric>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/segmentation/part_consistency.h"
#include "shapegauge/experiments/segmentation/write_segmentation.h"
#include "shapegauge/pages/html_page.h"

namespace shapegauge {

namespace {

/// Without scripts, so that the theme is the reader's system's.
constexpr std::string_view style = R"(
:root { color-scheme: light; --paper: #fff; --raised: #f6f7f8; --ink: #1c2227; --muted: #57616a; --rule: #d9dee2;
  --method-0: #0b62ad; --method-1: #c44e00; --method-2: #007d5c; --method-3: #a23b8c; --method-4: #80630a;
  --method-5: #5b6168; }
@media (prefers-color-scheme: dark) {
  :root { color-scheme: dark; --paper: #14181b; --raised: #1d2327; --ink: #e8ebee; --muted: #a3aeb7; --rule: #39424a;
    --method-0: #63b1f5; --method-1: #ff9349; --method-2: #40cf9f; --method-3: #ea8fd5; --method-4: #dfc04a;
    --method-5: #b9c1c8; }
}
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em;
  background: var(--paper); color: var(--ink); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1em 0; font-variant-numeric: tabular-nums; }
th, td { padding: .25em .8em; text-align: right; border-bottom: 1px solid var(--rule); }
th:first-child, td:first-child, .pairs td:nth-child(2), .pairs th:nth-child(2) { text-align: left; }
.bars { display: grid; grid-template-columns: max-content 1fr; gap: .15em .8em; align-items: center; }
.bars b { grid-column: 1 / -1; margin-top: .6em; }
.bar { height: .85em; min-width: 1px; display: inline-block; vertical-align: middle; margin-right: .5em; }
.shapes { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; border: 1px solid var(--rule); border-radius: 6px; padding: .5em; background: var(--raised);
  max-width: 100%; box-sizing: border-box; }
figcaption { font-weight: 600; }
.views { display: flex; flex-wrap: wrap; gap: .5em; }
.views div { text-align: center; font-size: 12px; color: var(--muted); }
figure img { display: block; max-width: 100%; background: #fff; border-radius: 4px; margin-bottom: .2em; }
)";

constexpr std::size_t bar_colours = 6;

std::string html_row(const std::vector<std::string>& cells, std::string_view tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, html_text(cell));
  return row + "</tr>\n";
}

std::string html_table(const Table& table) {
  std::string html = fmt::format("<div class=\"wide\"><table{}>\n", table.text_columns == 2 ? " class=\"pairs\"" : "") +
                     html_row(table.header, "th");
  for (const auto& row : table.rows) html += html_row(row, "td");
  return html + "</table></div>\n";
}

/// The mean Rand errors of all methods, class by class.
std::string class_bars(const SegmentationScores& scores) {
  std::string html = "<div class=\"bars\">\n";
  for (std::size_t c = 0; c < scores.classes.size(); ++c) {
    html += fmt::format("<b>{}</b>\n", html_text(scores.classes[c]));
    for (std::size_t m = 0; m < scores.methods.size(); ++m) {
      const double error = scores.mean(m, &SegmentationErrors::rand_index, static_cast<int>(c));
      if (std::isnan(error)) continue;
      html += fmt::format(
          "<span>{}</span><span><span class=\"bar\" "
          "style=\"width:{:.1f}%;background:var(--method-{})\"></span>{:.3f}</span>\n",
          html_text(scores.methods[m]), 90 * error, m % bar_colours, error);
    }
  }
  return html + "</div>\n";
}

std::string picture(std::string_view png, std::string_view caption) {
  return fmt::format("<div><img alt=\"\" src=\"data:image/png;base64,{}\">{}</div>", base64(png), html_text(caption));
}

/// A shape's parts as a person sees them and by each method.
std::string shape_figure(const SegmentationResults& results, std::size_t shape) {
  const SegmentationScores& scores = results.scores;
  const auto label = static_cast<std::size_t>(scores.labels[shape]);
  std::string html = fmt::format("<figure><figcaption>{} ({})</figcaption><div class=\"views\">",
                                 html_text(scores.ids[shape]), html_text(scores.classes[label]));
  const std::vector<std::string>& pictures = results.shapes[shape].pictures;
  const std::size_t people = results.has_people ? 1 : 0;
  if (people > 0) html += picture(pictures.front(), results.experiment.generator ? "as made" : "a person");
  for (std::size_t m = 0; m < results.experiment.methods.size(); ++m) {
    const std::string& method = results.experiment.methods[m].name;
    const double error = scores.errors[m][shape].rand_index;
    html += picture(pictures[m + people], people > 0 ? fmt::format("{}: {:.3f}", method, error) : method);
  }
  return html + "</div></figure>\n";
}

/// The shapes' indices, of greatest error of the first method first.
std::vector<std::size_t> worst_first(const SegmentationScores& scores) {
  std::vector<std::size_t> order(scores.ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t i) { return scores.errors.front()[i].rand_index; });
  return order;
}

/// Of each class the shape of median error.
std::vector<std::size_t> typical_shapes(const SegmentationScores& scores) {
  std::vector<std::vector<std::size_t>> by_class(scores.classes.size());
  for (const std::size_t i : worst_first(scores)) by_class[static_cast<std::size_t>(scores.labels[i])].push_back(i);
  std::vector<std::size_t> typical;
  for (const auto& shapes : by_class) {
    if (!shapes.empty()) typical.push_back(shapes[shapes.size() / 2]);
  }
  return typical;
}

std::string figures(const SegmentationResults& results, const std::vector<std::size_t>& shapes) {
  std::string html = "<div class=\"shapes\">\n";
  for (const std::size_t i : shapes) html += shape_figure(results, i);
  return html + "</div>\n";
}

/// What people think of it.
std::string errors_section(const SegmentationResults& results) {
  const SegmentationScores& scores = results.scores;
  std::string html = fmt::format("<h2>Errors</h2>\n<p>Less is better; triangles count {}.</p>\n",
                                 results.experiment.by_area ? "by area" : "alike") +
                     html_table(mean_table(scores));
  if (const std::optional<MethodComparison> comparison = rand_comparison(scores)) {
    html += html_table(interval_table(scores, *comparison)) + html_table(pair_table(scores, *comparison));
  }
  html += "<h2>Rand error by class</h2>\n" + class_bars(scores);
  return html + "<details><summary>The same as a table</summary>\n" + html_table(class_table(scores)) + "</details>\n";
}

}  // namespace

std::string segmentation_page(const SegmentationResults& results) {
  const SegmentationScores& scores = results.scores;
  const std::string name = html_text(results.experiment.name);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>{0} – shapegauge</title>\n<style>{1}</style>\n</head>\n"
      "<body>\n<h1>{0}</h1>\n<p>{2}</p>\n",
      name, style, html_text(results.experiment.description));
  html += fmt::format("<p>{} shapes of {} classes.</p>\n", scores.ids.size(), scores.classes.size());
  if (results.has_people) html += errors_section(results);
  if (const Table moved = moved_table(results); !moved.rows.empty()) {
    html += "<h2>Under damage</h2>\n<p>The Rand error of the parts against those of the undamaged shape.</p>\n" +
            html_table(moved);
  }
  html +=
      "<h2>Shapes of a class among each other</h2>\n<p>The median number of parts, the fraction of pairs of shapes "
      "with the same number, and how much the parts differ in size (0: not at all, 1: wholly): among the shapes of "
      "the class, and from those of other classes.</p>\n" +
      html_table(consistency_table(results));
  for (const LeftOutShape& failure : results.failures) {
    html += fmt::format("<p>Left out {}: {}</p>\n", html_text(failure.id), html_text(failure.message));
  }
  if (results.experiment.pictures) {
    html += fmt::format("<h2>Gallery</h2>\n<p>Of each class {}.</p>\n",
                        results.has_people ? "the shape of median error" : "one shape") +
            figures(results, typical_shapes(scores));
    if (results.has_people) {
      html +=
          fmt::format("<h2>Shapes, worst first</h2>\n<p>By the Rand error of {}.</p>\n", html_text(scores.methods[0])) +
          figures(results, worst_first(scores));
    } else {
      html += "<h2>Shapes</h2>\n" + figures(results, worst_first(scores));
    }
  }
  return html + "</body>\n</html>\n";
}

}  // namespace shapegauge
