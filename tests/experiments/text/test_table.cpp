#include <gtest/gtest.h>

#include "shapegauge/experiments/text/table.h"

namespace shapegauge {
namespace {

const Table table{.header = {"method", "NN"}, .rows = {{"a|b, 5 %", "9.5"}, {"é_x", "100.0"}}, .text_columns = 1};

TEST(Table, Csv) { EXPECT_EQ(to_csv(table), "method,NN\n\"a|b, 5 %\",9.5\né_x,100.0\n"); }

TEST(Table, PlainTextIsAlignedByLetters) {
  EXPECT_EQ(to_plain_text(table),
            "method       NN\n"
            "a|b, 5 %    9.5\n"
            "é_x       100.0\n");
}

TEST(Table, Markdown) {
  EXPECT_EQ(to_markdown(table),
            "| method    |    NN |\n"
            "| --------- | ----: |\n"
            "| a\\|b, 5 % |   9.5 |\n"
            "| é_x       | 100.0 |\n");
}

TEST(Table, Latex) {
  EXPECT_EQ(to_latex(table),
            "\\begin{tabular}{lr}\n"
            "\\hline\n"
            "method    &    NN \\\\\n"
            "\\hline\n"
            "a|b, 5 \\% &   9.5 \\\\\n"
            "é\\_x      & 100.0 \\\\\n"
            "\\hline\n"
            "\\end{tabular}\n");
}

TEST(Table, LatexEscapesEverySpecialCharacter) {
  const Table special{.header = {"\\~^&%$#_{}"}, .rows = {}, .text_columns = 1};
  EXPECT_NE(to_latex(special).find("\\textbackslash{}\\textasciitilde{}\\textasciicircum{}\\&\\%\\$\\#\\_\\{\\}"),
            std::string::npos);
}

}  // namespace
}  // namespace shapegauge
