// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const TextTable table{.header = {"method", "NN"}, .rows = {{"a|b, 5 %", "9.5"}, {"é_x", "100.0"}}, .text_columns = 1};

TEST(TextTable, IsWrittenAsCsv) { EXPECT_EQ(to_csv(table), "method,NN\n\"a|b, 5 %\",9.5\né_x,100.0\n"); }

TEST(TextTable, AlignsPlainTextByCharacters) {
  EXPECT_EQ(to_plain_text(table),
            "method       NN\n"
            "a|b, 5 %    9.5\n"
            "é_x       100.0\n");
}

TEST(TextTable, IsWrittenAsMarkdown) {
  EXPECT_EQ(to_markdown(table),
            "| method    |    NN |\n"
            "| --------- | ----: |\n"
            "| a\\|b, 5 % |   9.5 |\n"
            "| é_x       | 100.0 |\n");
}

TEST(TextTable, EscapesSpecialCharactersOfMarkdown) {
  const std::vector<std::pair<std::string, std::string>> cases{{"our_sdf 2 < 3 [1, 2] (a)", "our_sdf 2 < 3 [1, 2] (a)"},
                                                               {"*a* _b_ `c` ~d~", R"(\*a\* \_b\_ \`c\` \~d\~)"},
                                                               {"a|b\\c", R"(a\|b\\c)"},
                                                               {"<b>x</b> &lt;", R"(\<b>x\</b> \&lt;)"},
                                                               {"[x](y)", R"([x]\(y))"},
                                                               {"\u00e9_x", "\u00e9_x"}};
  for (const auto& [text, expected] : cases) EXPECT_EQ(markdown_text(text), expected);
}

TEST(TextTable, IsWrittenAsLatex) {
  EXPECT_EQ(to_latex(table),
            "\\begin{tabular}{lr}\n"
            "\\toprule\n"
            "method    &    NN \\\\\n"
            "\\midrule\n"
            "a|b, 5 \\% &   9.5 \\\\\n"
            "é\\_x      & 100.0 \\\\\n"
            "\\bottomrule\n"
            "\\end{tabular}\n");
}

TEST(TextTable, EscapesSpecialCharactersOfLatex) {
  const TextTable special{.header = {"\\~^&%$#_{}"}, .rows = {}, .text_columns = 1};
  EXPECT_NE(to_latex(special).find("\\textbackslash{}\\textasciitilde{}\\textasciicircum{}\\&\\%\\$\\#\\_\\{\\}"),
            std::string::npos);
}

// Two groups by the second column; in the first, two rows tie for the best as printed.
TextTable two_groups() {
  TextTable groups{.header = {"method", "average", "NN"},
                   .rows = {{"a", "x", "9.5"}, {"b", "x", "10.0 [9.0, 11.0]"}, {"c", "x", "10.0"}, {"d", "y", "3.0"}},
                   .text_columns = 2};
  groups.emphases.push_back({.row = 1, .column = 2, .bold = false, .mark = "ab"});
  embolden_best(groups, 1);
  return groups;
}

TEST(TextTable, PrintsTheBestValueOfEachRowGroupInBold) {
  EXPECT_THAT(to_latex(two_groups()),
              AllOf(HasSubstr("\\textbf{10.0 [9.0, 11.0]}\\textsuperscript{ab}"), HasSubstr("\\textbf{10.0} \\\\"),
                    Not(HasSubstr("\\textbf{9.5}")), Not(HasSubstr("\\textbf{3.0}"))));
  EXPECT_THAT(to_markdown(two_groups()),
              AllOf(HasSubstr("| **10.0 [9.0, 11.0]** <sup>ab</sup> |"), HasSubstr("**10.0** |")));
}

TEST(TextTable, AlignsBoldCellsInTerminals) {
  EXPECT_EQ(to_plain_text(two_groups(), true),
            "method  average                   NN\n"
            "a       x                        9.5\n"
            "b       x        \x1b[1m10.0 [9.0, 11.0] ab\x1b[0m\n"
            "c       x                       \x1b[1m10.0\x1b[0m\n"
            "d       y                        3.0\n");
}

TEST(TextTable, PrintsSignificanceLettersInPlainTextButNotInCsv) {
  EXPECT_THAT(to_plain_text(two_groups()), HasSubstr("10.0 [9.0, 11.0] ab\n"));
  EXPECT_THAT(to_csv(two_groups()), HasSubstr("b,x,\"10.0 [9.0, 11.0]\"\n"));
}

}  // namespace

}  // namespace shapegauge
