// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/mat_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <matio.h>
#include <memory>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/exact_number.h"

namespace shapegauge {

namespace {

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

// MATLAB's matrices are stored column by column.
template <typename Number>
void copy_numbers(const matvar_t& variable, DistanceMatrix& matrix) {
  using Columns = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  matrix = Eigen::Map<const Columns>(static_cast<const Number*>(variable.data), matrix.rows(), matrix.cols())
               .unaryExpr(&exact_number<Number>);
}

using CopyNumbers = void (*)(const matvar_t&, DistanceMatrix&);

// Returns the function that copies numbers of a class; null for other classes.
CopyNumbers copier_of(matio_classes numbers) {
  switch (numbers) {
    case MAT_C_DOUBLE:
      return copy_numbers<double>;
    case MAT_C_SINGLE:
      return copy_numbers<float>;
    case MAT_C_INT8:
      return copy_numbers<mat_int8_t>;
    case MAT_C_UINT8:
      return copy_numbers<mat_uint8_t>;
    case MAT_C_INT16:
      return copy_numbers<mat_int16_t>;
    case MAT_C_UINT16:
      return copy_numbers<mat_uint16_t>;
    case MAT_C_INT32:
      return copy_numbers<mat_int32_t>;
    case MAT_C_UINT32:
      return copy_numbers<mat_uint32_t>;
    case MAT_C_INT64:
      return copy_numbers<mat_int64_t>;
    case MAT_C_UINT64:
      return copy_numbers<mat_uint64_t>;
    default:
      return nullptr;
  }
}

bool is_matrix(const matvar_t& variable) {
  return variable.rank == 2 && variable.isComplex == 0 && copier_of(variable.class_type) != nullptr &&
         variable.dims[0] > 0 && variable.dims[1] > 0;
}

// Describes a variable that is no real matrix.
std::string_view kind_of(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_SPARSE:
      return "sparse, use full()";
    case MAT_C_CELL:
      return "a cell array";
    case MAT_C_STRUCT:
      return "a structure";
    case MAT_C_CHAR:
      return "text";
    default:
      break;
  }
  if (variable.isComplex != 0) return "complex";
  return copier_of(variable.class_type) != nullptr ? "an array of another rank"
                                                   : "of a class that MATLAB does not write, save it as .npy";
}

// Variables of a file.
struct Variables {
  std::vector<std::string> matrices;
  std::vector<std::string> scalars;
  std::vector<std::string> others;  // with their kinds
};

Variables variables_of(mat_t* file) {
  Variables found;
  while (const Variable variable{Mat_VarReadNextInfo(file)}) {
    const std::string name = variable->name == nullptr ? "" : variable->name;
    if (!is_matrix(*variable)) {
      found.others.push_back(fmt::format("{} is {}", name, kind_of(*variable)));
    } else {
      const bool scalar = variable->dims[0] == 1 && variable->dims[1] == 1;
      (scalar ? found.scalars : found.matrices).push_back(name);
    }
  }
  if (found.matrices.empty()) found.matrices.swap(found.scalars);
  return found;
}

// Returns the name of the matrix to read.
std::string chosen_matrix(const Variables& variables, const std::string& requested, const std::string& source) {
  const auto listed = [](const std::vector<std::string>& words) {
    return printable(fmt::format("{}", fmt::join(words, ", ")), 200);
  };
  const bool found = std::ranges::find(variables.matrices, requested) != variables.matrices.end();
  if (found) return requested;
  if (requested.empty() && variables.matrices.size() == 1) return variables.matrices.front();
  if (variables.matrices.empty()) {
    throw InputError(fmt::format("{}: no matrix of real numbers{}{}", source,
                                 variables.others.empty() ? "" : "; other variables: ", listed(variables.others)));
  }
  throw InputError(
      requested.empty()
          ? fmt::format("{}: several matrices: {}; choose one with `variable`", source, listed(variables.matrices))
          : fmt::format("{}: no matrix {}; there are {}", source, quoted_word(requested), listed(variables.matrices)));
}

}  // namespace

DistanceMatrix read_mat(const std::filesystem::path& path, const std::string& variable) {
  read_file_bytes(path, 1);  // reports unreadable files
  Mat_LogInitFunc("shapegauge", [](int, auto*) {});
  const std::unique_ptr<mat_t, CloseFile> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (file == nullptr) throw InputError(fmt::format("{}: not a .mat file, or damaged", path.string()));
  const std::string name = chosen_matrix(variables_of(file.get()), variable, path.string());
  const Variable info{Mat_VarReadInfo(file.get(), name.c_str())};
  // Numbers may be compressed, and the announced size may be wrong.
  const std::size_t packed = std::filesystem::file_size(path);
  const double bytes = info == nullptr ? 0
                                       : static_cast<double>(info->dims[0]) * static_cast<double>(info->dims[1]) *
                                             static_cast<double>(Mat_SizeOfClass(info->class_type));
  if (bytes > static_cast<double>(max_unpacked_bytes(packed))) fail_unpacking(path.string(), packed);
  const Variable matrix_variable{Mat_VarRead(file.get(), name.c_str())};
  if (matrix_variable == nullptr || matrix_variable->data == nullptr) {
    throw InputError(fmt::format("{}: the matrix {} cannot be read; the file is truncated or damaged", path.string(),
                                 printable(name, 60)));
  }
  DistanceMatrix matrix(static_cast<Eigen::Index>(matrix_variable->dims[0]),
                        static_cast<Eigen::Index>(matrix_variable->dims[1]));
  with_source(path.string(), [&] { copier_of(matrix_variable->class_type)(*matrix_variable, matrix); });
  return matrix;
}

}  // namespace shapegauge
