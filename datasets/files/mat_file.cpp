#include "shapegauge/datasets/files/mat_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <matio.h>
#include <memory>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/compressed_files.h"

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
               .template cast<double>();
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

}  // namespace

DistanceMatrix read_mat(const std::filesystem::path& path) {
  read_file_bytes(path, 1);  // says why where it cannot be read at all
  Mat_LogInitFunc("shapegauge", [](int, char*) {});
  const std::unique_ptr<mat_t, CloseFile> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (file == nullptr) throw InputError(fmt::format("{}: not a .mat file, or damaged", path.string()));
  std::vector<std::string> names;
  double bytes = 0;
  while (const Variable variable{Mat_VarReadNextInfo(file.get())}) {
    if (!is_matrix(*variable)) continue;
    names.emplace_back(variable->name);
    bytes = static_cast<double>(variable->dims[0]) * static_cast<double>(variable->dims[1]) *
            static_cast<double>(Mat_SizeOfClass(variable->class_type));
  }
  if (names.size() != 1) {
    throw InputError(
        fmt::format("{}: expected one matrix of real numbers, but the file has {}{}", path.string(),
                    names.empty() ? "none" : "several: ", printable(fmt::format("{}", fmt::join(names, ", ")), 60)));
  }
  // Numbers may be compressed, and the announced size may be wrong.
  const std::size_t packed = std::filesystem::file_size(path);
  if (bytes > static_cast<double>(most_unpacked_bytes(packed))) fail_unpacking(path.string(), packed);
  const Variable variable{Mat_VarRead(file.get(), names.front().c_str())};
  if (variable == nullptr || variable->data == nullptr) {
    throw InputError(fmt::format("{}: the matrix {} cannot be read; the file is truncated or damaged", path.string(),
                                 printable(names.front(), 60)));
  }
  DistanceMatrix matrix(static_cast<Eigen::Index>(variable->dims[0]), static_cast<Eigen::Index>(variable->dims[1]));
  copier_of(variable->class_type)(*variable, matrix);
  return matrix;
}

}  // namespace shapegauge
