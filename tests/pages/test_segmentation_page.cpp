#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/palette.h"
#include "shapegauge/pages/segmentation_page.h"
#include "tests/support/page_text.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A page whose names are markup, with one method more than there are colours and one error that is not defined.
SegmentationPage sample_segmentation_page() {
  SegmentationPage page;
  page.title = "<b>title</b> {{content}}";
  page.description = "a \"description\" & more";
  page.shapes = 2;
  page.classes = 1;
  page.consistency = {.header = {"method", "parts"}, .rows = {{"<i>", "3"}}};
  SegmentationPageErrors errors{.triangle_weights = "by area",
                                .tables = {{.header = {"method", "Rand"}, .rows = {{"a", "0.100"}}}},
                                .methods = {},
                                .classes = {{.name = "</style>", .errors = {}}},
                                .class_table = {.header = {"class"}, .rows = {}}};
  for (std::size_t i = 0; i <= method_colours; ++i) {
    errors.methods.push_back("method " + std::to_string(i));
    errors.classes.front().errors.push_back(i == 1 ? std::nan("") : 0.5);
  }
  page.errors = errors;
  page.failures = {{"lost.off", "line 3: <nothing>"}};
  return page;
}

TEST(SegmentationPage, ShowsTextAsTextWithoutScripts) {
  const std::string html = segmentation_page(sample_segmentation_page());
  EXPECT_THAT(html, HasSubstr("<h1>&lt;b&gt;title&lt;/b&gt; {{content}}</h1>"));
  EXPECT_THAT(html, HasSubstr("lost.off: line 3: &lt;nothing&gt;"));
  for (const char* word : {"<script", "<b>title", "<i>", "http://", "https://", "@import", "<link"}) {
    EXPECT_THAT(html, Not(HasSubstr(word)));
  }
  EXPECT_EQ(test::occurrences(html, "</style>"), 1);
}

TEST(SegmentationPage, HasABarForEachErrorInTheColourOfItsMethod) {
  const std::string html = segmentation_page(sample_segmentation_page());
  EXPECT_EQ(test::occurrences(html, "class=\"bar\""), method_colours);  // all methods but the one without an error
  EXPECT_EQ(test::occurrences(html, "width:45.0%;background:var(--method-0)"), 2);
  EXPECT_EQ(test::occurrences(html, "background:var(--method-1)"), 0);
}

TEST(SegmentationPage, ShowsPicturesOrNoGallery) {
  SegmentationPage page = sample_segmentation_page();
  EXPECT_THAT(segmentation_page(page), Not(HasSubstr("Gallery")));
  page.shown = {{.title = "shape", .pictures = {{.png = "bytes", .caption = "a <person>"}}}};
  EXPECT_THAT(segmentation_page(page), HasSubstr("base64," + base64("bytes") + "\">a &lt;person&gt;"));
}

TEST(SegmentationPage, WithoutPeopleHasNoErrors) {
  SegmentationPage page = sample_segmentation_page();
  page.errors.reset();
  EXPECT_THAT(segmentation_page(page), Not(HasSubstr("Errors")));
}

}  // namespace
}  // namespace shapegauge
