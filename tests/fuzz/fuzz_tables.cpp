#include "shapegauge/experiments/datasets/classification_file.h"
#include "shapegauge/experiments/matrices/csv_matrix.h"
#include "shapegauge/experiments/matrices/npy.h"
#include "shapegauge/experiments/matrices/psb_matrix.h"
#include "shapegauge/experiments/matrices/text_matrix.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/promises.h"

namespace shapegauge::fuzz {

namespace {

void promise_square(const DistanceMatrix& matrix) {
  promise(matrix.rows() > 0 && matrix.rows() == matrix.cols(), "a matrix is square and not empty");
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
  return is_accepted("matrix:", [&] { promise_square(parse_npy(bytes, "matrix")); });
}

bool text_matrix(std::string_view bytes) {
  return is_accepted("matrix:", [&] { promise_square(parse_text_matrix(bytes, "matrix")); });
}

bool csv_matrix(std::string_view bytes) {
  return is_accepted("matrix:", [&] {
    const LabelledDistances matrix = parse_csv_matrix(bytes, "matrix");
    promise_square(matrix.distances);
    promise(matrix.ids.empty() || std::ssize(matrix.ids) == matrix.distances.rows(), "there is an id for each row");
  });
}

bool psb_matrix(std::string_view bytes) {
  return is_accepted("matrix:", [&] { promise_square(parse_psb_matrix(bytes, "matrix")); });
}

}  // namespace shapegauge::fuzz
