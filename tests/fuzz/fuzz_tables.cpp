// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <vector>

#include "shapegauge/datasets/files/classification.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/files/text_matrices.h"
#include "shapegauge/segmentation/seg_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/promises.h"

namespace shapegauge::fuzz {

namespace {

void promise_square(const DistanceMatrix& matrix) {
  promise(matrix.rows() > 0 && matrix.rows() == matrix.cols(), "a matrix is square and not empty");
}

void promise_answers(const RankedAnswers& answers) {
  promise(!answers.answers.empty(), "there are answers");
  for (const RankedAnswers::Answer& answer : answers.answers) {
    promise(!answer.query.empty() && !answer.models.empty(), "an answer has a query and models");
  }
}

}  // namespace

bool classification(std::string_view bytes) {
  return is_accepted("classes:", [&] {
    const Classification read = parse_classification(bytes, "classes");
    promise(model_count(read) > 0, "a classification has models");
    promise(parse_classification(format_classification(read), "again") == read, "what is written reads back the same");
  });
}

bool npy(std::string_view bytes) {
  return is_accepted("matrix:", [&] { promise_square(parse_npy(bytes, "matrix", TableShape::square)); });
}

bool text_matrix(std::string_view bytes) {
  return is_accepted("matrix:", [&] { promise_square(parse_text_matrix(bytes, "matrix", TableShape::square)); });
}

bool csv_matrix(std::string_view bytes) {
  return is_accepted("matrix:", [&] {
    const LabelledTable matrix = parse_csv_matrix(bytes, "matrix");
    promise_square(matrix.numbers);
    promise(matrix.row_ids.empty() || std::ssize(matrix.row_ids) == matrix.numbers.rows(),
            "there is an id for each row");
    promise(matrix.row_ids == matrix.column_ids, "rows and columns have the same ids");
  });
}

bool psb_matrix(std::string_view bytes) {
  return is_accepted("matrix:", [&] { promise_square(parse_psb_matrix(bytes, "matrix")); });
}

bool npy_strings(std::string_view bytes) {
  bool are_strings = false;
  const bool accepted = is_accepted("labels:", [&] {
    const auto strings = parse_npy_strings(bytes, "labels");
    are_strings = strings.has_value();
    promise(!strings || !strings->empty(), "an array of strings is not empty");
  });
  return accepted && are_strings;
}

bool npy_table(std::string_view bytes) {
  return is_accepted("matrix:",
                     [&] { promise(parse_npy(bytes, "matrix", TableShape::any).size() > 0, "a table is not empty"); });
}

bool csv_table(std::string_view bytes) {
  return is_accepted("matrix:", [&] {
    const LabelledTable table = parse_csv_table(bytes, "matrix");
    promise(table.numbers.size() > 0, "a table is not empty");
    promise(table.row_ids.empty() || std::ssize(table.row_ids) == table.numbers.rows(), "there is an id for each row");
    promise(table.column_ids.empty() || std::ssize(table.column_ids) == table.numbers.cols(),
            "there is an id for each column");
  });
}

bool trec_run(std::string_view bytes) {
  return is_accepted("run:", [&] { promise_answers(parse_trec_run(bytes, "run")); });
}

bool ranked_lists(std::string_view bytes) {
  return is_accepted("lists:", [&] { promise_answers(parse_ranked_lists(bytes, "lists")); });
}

bool seg(std::string_view bytes) {
  const auto faces = static_cast<std::size_t>(std::ranges::count(bytes, '\n'));
  return is_accepted("parts", [&] {
    const std::vector<std::int32_t> segments = parse_seg(std::string(bytes), "parts", faces);
    promise(segments.size() == faces, "there is a segment for each face");
    promise(std::ranges::all_of(segments, [](std::int32_t s) { return s >= 0; }), "segments have numbers from 0 on");
  });
}

bool qrels(std::string_view bytes) {
  return is_accepted("qrels:", [&] { promise(!parse_qrels(bytes, "qrels").queries.empty(), "there are queries"); });
}

}  // namespace shapegauge::fuzz
