// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <memory>
#include <optional>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <type_traits>
#include <utility>

#include "python/interruptible.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/words.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/engine/run_control.h"

/// Declarations shared by the sources of the native Python module.

namespace shapegauge {

/// Python callback that receives the stage of a run, the number of items done and the total; None for no progress.
using PythonProgress = std::optional<std::function<void(std::string, std::size_t, std::size_t)>>;

/// Returns the RunControl of a run on `threads` threads that Ctrl-C stops by `cancellation`. Calls `progress` with the
/// lock of the Python interpreter (GIL) held; an exception from it stops the run as well. All references must outlive
/// the result.
RunControl interruptible_control(int threads, Cancellation& cancellation, const PythonProgress& progress);

/// Runs `work` with the lock of the Python interpreter (GIL) released, on at most `threads` threads (0: all cores),
/// and returns its result. Ctrl-C stops the work and throws Python's KeyboardInterrupt.
template <typename Work>
auto compute(int threads, const Work& work) {
  std::optional<decltype(work())> result;
  Cancellation cancellation;
  const RunControl control{.threads = threads, .cancellation = &cancellation};
  run_interruptibly(cancellation, [&] { with_threads(control, [&] { result.emplace(work()); }); });
  return std::move(*result);
}

/// Returns the value of an enumeration that a word names (words_of). Throws InputError for an unknown word; `kind`
/// names the enumeration in the message, such as "protocol".
template <typename Enumeration>
Enumeration known_word(const char* kind, const std::string& word) {
  if (const auto value = value_of_word<Enumeration>(word)) return *value;
  const auto& words = words_of<Enumeration>;
  throw InputError(fmt::format("unknown {} \"{}\"; known are {} and {}", kind, word,
                               fmt::join(words.begin(), words.end() - 1, ", "), words.back()));
}

/// Converts an Eigen matrix to a NumPy array that owns it, without copying; one-dimensional for a column vector.
template <typename Matrix>
pybind11::array array_of(Matrix&& matrix) {
  auto owned = std::make_unique<std::decay_t<Matrix>>(std::forward<Matrix>(matrix));
  const auto* values = owned.get();
  const pybind11::capsule owner(owned.release(),
                                [](void* pointer) { delete static_cast<std::decay_t<Matrix>*>(pointer); });
  using Scalar = typename std::decay_t<Matrix>::Scalar;
  if constexpr (std::decay_t<Matrix>::ColsAtCompileTime == 1) {
    return pybind11::array_t<Scalar>({values->rows()}, {sizeof(Scalar)}, values->data(), owner);
  } else {
    const std::size_t row = std::decay_t<Matrix>::IsRowMajor ? static_cast<std::size_t>(values->cols()) : 1;
    const std::size_t column = std::decay_t<Matrix>::IsRowMajor ? 1 : static_cast<std::size_t>(values->rows());
    return pybind11::array_t<Scalar>({values->rows(), values->cols()}, {row * sizeof(Scalar), column * sizeof(Scalar)},
                                     values->data(), owner);
  }
}

/// Makes a shape from arrays of vertices (n x 3), triangles (`faces`, m x 3 vertex indices) and vertex normals (n x 3);
/// triangles and normals may be empty. Throws InputError if the shape is not usable (require_usable()).
Shape shape_of(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
               const Eigen::Ref<const Points>& normals);

/// Adds the functions of one topic, which the name states, to the Python module.
/// @{
void bind_shapes(pybind11::module_& module);      ///< adds functions on shapes, fields, segments and descriptors
void bind_check(pybind11::module_& module);       ///< adds the function that checks thin walls and narrow gaps
void bind_evaluation(pybind11::module_& module);  ///< adds functions that evaluate distance matrices
void bind_comparison(pybind11::module_& module);  ///< adds functions that compare retrieval methods
void bind_search(pybind11::module_& module);      ///< adds functions that search an index of shapes
/// Adds settings(), which returns all settings of fields, descriptors and experiments with their descriptions as JSON.
void bind_settings(pybind11::module_& module);
/// @}

}  // namespace shapegauge
