#include "shapegauge/pages/segmentation_page.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

std::string html_row(const std::vector<std::string>& cells, std::string_view tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, html_text(cell));
  return row + "</tr>\n";
}

std::string html_table(const TextTable& table) {
  std::string html = fmt::format("<div class=\"wide\"><table{}>\n", table.text_columns == 2 ? " class=\"pairs\"" : "") +
                     html_row(table.header, "th");
  for (const auto& row : table.rows) html += html_row(row, "td");
  return html + "</table></div>\n";
}

/// Renders the mean Rand errors of all methods, class by class.
std::string class_bars(const SegmentationPageErrors& errors) {
  std::string html = "<div class=\"bars\">\n";
  for (const SegmentationClassErrors& one : errors.classes) {
    html += fmt::format("<b>{}</b>\n", html_text(one.name));
    for (std::size_t m = 0; m < one.errors.size(); ++m) {
      if (std::isnan(one.errors[m])) continue;
      html += fmt::format(
          "<span>{}</span><span><span class=\"bar\" "
          "style=\"width:{:.1f}%;background:var(--method-{})\"></span>{:.3f}</span>\n",
          html_text(errors.methods[m]), 90 * one.errors[m], m % method_colours, one.errors[m]);
    }
  }
  return html + "</div>\n";
}

std::string figures(const std::vector<SegmentationFigure>& shapes) {
  std::string html = "<div class=\"shapes\">\n";
  for (const SegmentationFigure& shape : shapes) {
    html += fmt::format("<figure><figcaption>{}</figcaption><div class=\"views\">", html_text(shape.title));
    for (const SegmentationPicture& picture : shape.pictures) {
      html += fmt::format("<div><img alt=\"\" src=\"data:image/png;base64,{}\">{}</div>", base64(picture.png),
                          html_text(picture.caption));
    }
    html += "</div></figure>\n";
  }
  return html + "</div>\n";
}

std::string errors_section(const SegmentationPageErrors& errors) {
  std::string html =
      fmt::format("<h2>Errors</h2>\n<p>Less is better; triangles count {}.</p>\n", html_text(errors.triangle_weights));
  for (const TextTable& table : errors.tables) html += html_table(table);
  html += "<h2>Rand error by class</h2>\n" + class_bars(errors);
  return html + "<details><summary>The same as a table</summary>\n" + html_table(errors.class_table) + "</details>\n";
}

std::string gallery_sections(const SegmentationPage& page) {
  std::string html = fmt::format("<h2>Gallery</h2>\n<p>Of each class {}.</p>\n",
                                 page.errors ? "the shape of median error" : "one shape") +
                     figures(page.typical);
  if (page.errors) {
    html += fmt::format("<h2>Shapes, worst first</h2>\n<p>By the Rand error of {}.</p>\n",
                        html_text(page.errors->methods.front()));
  } else {
    html += "<h2>Shapes</h2>\n";
  }
  return html + figures(page.shown);
}

std::string sections(const SegmentationPage& page) {
  std::string html;
  if (page.errors) html += errors_section(*page.errors);
  if (!page.moved.rows.empty()) {
    html += "<h2>Under damage</h2>\n<p>The Rand error of the parts against those of the undamaged shape.</p>\n" +
            html_table(page.moved);
  }
  html +=
      "<h2>Shapes of a class among each other</h2>\n<p>The median number of parts, the fraction of pairs of shapes "
      "with the same number, and how much the parts differ in size (0: not at all, 1: wholly): among the shapes of "
      "the class, and from those of other classes.</p>\n" +
      html_table(page.consistency);
  for (const auto& [name, message] : page.failures) {
    html += fmt::format("<p>Left out {}: {}</p>\n", html_text(name), html_text(message));
  }
  return page.shown.empty() ? html : html + gallery_sections(page);
}

}  // namespace

std::string segmentation_page(const SegmentationPage& page) {
  const std::string title = html_text(page.title);
  const std::string style = palette_style().append(page_files::common_style()).append(page_files::segmentation_style());
  const std::string facts = fmt::format("{} shapes of {} classes", page.shapes, page.classes);
  const std::string description = html_text(page.description);
  const std::string content = sections(page);
  const std::array<std::pair<std::string_view, std::string_view>, 7> marks{{{"{{title}}", title},
                                                                            {"{{style}}", style},
                                                                            {"{{title}}", title},
                                                                            {"{{description}}", description},
                                                                            {"{{facts}}", facts},
                                                                            {"{{content}}", content},
                                                                            {"{{version}}", version()}}};
  return filled_page(page_files::segmentation_page(), marks);
}

}  // namespace shapegauge
