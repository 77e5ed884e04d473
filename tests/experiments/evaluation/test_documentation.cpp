// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/core/base/text.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distances.h"
#include "tests/support/test_files.h"

// The worked example of docs/reference/definitions.md: numbers on the page must be those of the library.

namespace shapegauge {
namespace {

using test::text_of;

const std::string& guide() {
  static const std::string text = text_of(SHAPEGAUGE_SOURCE_FOLDER "/docs/reference/definitions.md");
  return text;
}

// The indented block after the first line that contains the words, without indentation.
std::string block_after(const std::string& words) {
  std::string block;
  bool found = false;
  for (const std::string_view line : split_lines(std::string_view(guide()).substr(guide().find(words)))) {
    const bool indented = line.starts_with("    ");
    if (found && !indented) break;
    found = found || indented;
    if (indented) block += std::string(line.substr(4)) + '\n';
  }
  return block;
}

// Rows of the Markdown table after a heading, with trimmed cells.
std::vector<std::vector<std::string>> table_after(const std::string& heading) {
  std::vector<std::vector<std::string>> rows;
  for (std::string_view line : split_lines(std::string_view(guide()).substr(guide().find(heading)))) {
    if (!line.starts_with('|')) {
      if (rows.empty()) continue;
      break;
    }
    rows.emplace_back();
    line.remove_prefix(1);
    while (line.find('|') != std::string_view::npos) {
      rows.back().emplace_back(trim(line.substr(0, line.find('|'))));
      line.remove_prefix(line.find('|') + 1);
    }
  }
  rows.erase(rows.begin(), rows.begin() + 2);  // header and separator
  return rows;
}

class DocumentedExample : public test::FolderTest {
 protected:
  DocumentedExample() {
    test::write_text(at("five.csv"), block_after("`five.csv`"));
    test::write_text(at("classes.csv"), block_after("`classes.csv`"));
    input = open_evaluation_files({.matrix = at("five.csv"), .labels = at("classes.csv")});
  }

  // The measure of the query a1.
  [[nodiscard]] double value(const std::string& measure, const std::string& protocol = "psb",
                             const std::string& ties = "index") const {
    EvaluationOptions options;
    options.protocol = value_of_word<Protocol>(protocol).value();
    options.ties = value_of_word<Ties>(ties).value();
    options.measures = {measure_of(measure)};
    return evaluate(whole_matrix(input.distances), input.task.retrieval, options).per_query(0, 0);
  }

  EvaluationData input;
};

void expect_printed(const std::string& printed, double value, const std::string& what) {
  const auto number = parse_number(printed);
  ASSERT_TRUE(number) << what << ": " << printed;
  EXPECT_NEAR(*number, value, 0.00005) << what;
}

TEST_F(DocumentedExample, HasTheStatedValueOfEveryMeasure) {
  const auto rows = table_after("## Measures");
  std::size_t worked = 0;
  for (const MeasureDefinition& definition : measure_definitions().entries()) {
    for (const auto& row : rows) {
      const bool same =
          row[0] == definition.name || (definition.value_at != nullptr && !row[0].ends_with("@N") &&
                                        row[0].starts_with(definition.name.substr(0, definition.name.size() - 1)));
      if (!same) continue;
      ++worked;
      expect_printed(row.back(), value(row[0]), row[0]);
    }
  }
  EXPECT_EQ(worked, measure_definitions().entries().size());
  EXPECT_EQ(rows.size(), worked);
}

TEST_F(DocumentedExample, HasTheStatedValueUnderEachProtocol) {
  for (const auto& row : table_after("## Protocols")) {
    expect_printed(row[1], value(row[0], "psb"), row[0] + " psb");
    expect_printed(row[2], value(row[0], "paper"), row[0] + " paper");
  }
}

TEST_F(DocumentedExample, HasTheStatedValueForEachOrderOfTies) {
  const auto rows = table_after("## Ties");
  EXPECT_EQ(rows.size(), list_of_words<Ties>().size());
  for (const auto& row : rows) {
    const std::string ties = row[0].substr(1, row[0].size() - 2);  // between backticks
    expect_printed(row[2], value("mAP", "psb", ties), "mAP " + ties);
    expect_printed(row[3], value("DCG", "psb", ties), "DCG " + ties);
  }
}

TEST(EvaluationGuide, ListsAllRegisteredDistances) {
  std::vector<std::string> named;
  for (const auto& row : table_after("## Distances")) {
    for (std::string_view cell = row[0]; cell.find('`') != std::string_view::npos;) {
      cell.remove_prefix(cell.find('`') + 1);
      named.emplace_back(cell.substr(0, cell.find('`')));
      cell.remove_prefix(named.back().size() + 1);
    }
  }
  EXPECT_THAT(named, testing::UnorderedElementsAreArray(distances().names()));
}

TEST(EvaluationGuide, ListsAllRegisteredProtocolsAndCurves) {
  for (const std::string& name : list_of_words<Protocol>())
    EXPECT_THAT(guide(), testing::HasSubstr("\n| `" + name + "`"));
  const std::string curves = guide().substr(guide().find("## Precision-recall"));
  for (const std::string& name : list_of_words<CurveKind>())
    EXPECT_THAT(curves, testing::HasSubstr("\n| `" + name + "` |"));
}

}  // namespace
}  // namespace shapegauge
