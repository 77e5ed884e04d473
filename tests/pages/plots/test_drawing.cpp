// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/pages/plots/drawing.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

Drawing small_drawing() {
  Drawing drawing{.width = 40, .height = 20, .elements = {}};
  drawing.rectangle({0, 0}, {20, 20}, {255, 0, 0});
  drawing.path({.points = {{20, 10}, {40, 10}}, .stroke = Colour{0, 0, 255}, .width = 4, .dashes = {2, 3}});
  drawing.text({.text = "a < b & \"c\"", .position = {2, 12}, .anchor = TextAnchor::end, .upwards = true});
  return drawing;
}

std::array<int, 4> pixel(const Image& image, int x, int y) {
  const int pixel = y * image.width + x;
  const std::size_t first = 4 * static_cast<std::size_t>(pixel);
  return {image.pixels[first], image.pixels[first + 1], image.pixels[first + 2], image.pixels[first + 3]};
}

TEST(Drawing, SvgContainsPathsDashesAndText) {
  const std::string svg = to_svg(small_drawing());
  EXPECT_NE(svg.find("viewBox=\"0 0 40 20\""), std::string::npos);
  EXPECT_NE(svg.find("<path d=\"M0 0L20 0L20 20L0 20Z\" fill=\"#ff0000\"/>"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray=\"2 3\""), std::string::npos);
  EXPECT_NE(svg.find("text-anchor=\"end\" transform=\"rotate(-90 2 12)\">a &lt; b &amp; &quot;c&quot;</text>"),
            std::string::npos);
}

TEST(Drawing, PngHasTheColoursOfTheDrawing) {
  Drawing drawing{.width = 40, .height = 20, .elements = {}};
  drawing.rectangle({0, 0}, {20, 20}, {255, 0, 0});
  const Image image = to_image(drawing, 1);
  EXPECT_EQ(image.width, 40);
  EXPECT_EQ(image.height, 20);
  EXPECT_EQ(pixel(image, 5, 5), (std::array{255, 0, 0, 255}));
  EXPECT_EQ(pixel(image, 30, 5), (std::array{255, 255, 255, 255}));
  EXPECT_EQ(pixel(to_image(drawing, 1, true), 30, 5)[3], 0);
  EXPECT_EQ(to_image(drawing, 3).width, 120);
}

TEST(Drawing, PdfIsReproducible) {
  const std::string pdf = to_pdf(small_drawing());
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4"));
  EXPECT_NE(pdf.find("MediaBox [ 0 0 40 20 ]"), std::string::npos);
  EXPECT_EQ(pdf, to_pdf(small_drawing()));
}

TEST(Drawing, SelectsTheFormatByExtension) {
  const test::TemporaryFolder folder;
  for (const auto& [name, beginning] : {std::pair{"a.svg", "<svg"}, {"a.PDF", "%PDF"}, {"a.png", "\x89PNG"}}) {
    write_drawing(folder.path() / name, small_drawing());
    EXPECT_TRUE(read_file_bytes(folder.path() / name).starts_with(beginning)) << name;
  }
  EXPECT_THROW(write_drawing(folder.path() / "a.eps", small_drawing()), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.eps"));
}

TEST(Drawing, TextWidthsCountCharactersAndNotBytes) {
  EXPECT_DOUBLE_EQ(estimated_text_width("\xc3\xa4\xc3\xb6", 10), estimated_text_width("ao", 10));
  EXPECT_GT(estimated_text_width("mm", 10), estimated_text_width("ii", 10));
}

}  // namespace
}  // namespace shapegauge
