// SPDX-License-Identifier: GPL-3.0-or-later
// Searches, for shapegauge/_search.py.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/native.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/search/page_of_answers.h"
#include "shapegauge/experiments/search/search.h"

namespace py = pybind11;

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Method of a search: a recommended one, or that of a configuration.
struct MethodRequest {
  std::string configuration;  ///< as JSON; if empty, that of the file `source`
  std::string source;         ///< name in messages; if empty, a recommended method
  std::string signature;      ///< if empty, the last one
  RecommendedMethod recommended = RecommendedMethod::any;
};

/// Open index with its cache and the notes of the last call.
struct NativeIndex {
  OpenIndex index;
  std::unique_ptr<Cache> cache;
  std::vector<std::string> notes;
  std::vector<std::string> left_out;
};

SearchMethod method_of(const MethodRequest& request) {
  if (request.source.empty()) return recommended_search_method(request.recommended);
  if (request.configuration.empty()) return read_search_method(request.source, {}, request.signature);
  return search_method(parse_json(request.configuration, request.source), request.source, request.signature);
}

std::unique_ptr<NativeIndex> open(const fs::path& collection, const std::optional<fs::path>& file,
                                  const MethodRequest& request, const fs::path& configuration_file, bool update,
                                  const std::optional<fs::path>& cache, int threads, const PythonProgress& progress) {
  auto opened = std::make_unique<NativeIndex>();
  opened->cache = std::make_unique<Cache>(cache.value_or(default_cache_folder()));
  const bool articulated = request.recommended == RecommendedMethod::articulated;
  const fs::path index_path = file.value_or(default_index_path(
      collection, articulated ? fs::path(recommended_file(request.recommended)) : configuration_file));
  Cancellation cancellation;
  const RunControl control = interruptible_control(threads, cancellation, progress);
  run_interruptibly(cancellation, [&] {
    SearchMethod method = method_of(request);
    if (!update) {
      opened->index = open_index_without_update(std::move(method), collection, index_path);
      copy_tables_to_memory(opened->index.contents);
      return;
    }
    IndexUpdate done;
    opened->index = open_index(std::move(method), collection, index_path, control, *opened->cache, done);
    copy_tables_to_memory(opened->index.contents);
    opened->notes = std::move(done.notes);
    for (const LeftOutShape& one : done.left_out) opened->left_out.push_back(one.id + ": " + one.message);
  });
  return opened;
}

/// Makes a query from a path, or the arrays of a shape.
SearchQuery query_of(const py::handle& object, std::size_t number) {
  if (!py::isinstance<py::tuple>(object)) {
    const auto file = object.cast<fs::path>();
    return {.name = file.string(), .file = file};
  }
  const auto arrays = object.cast<py::tuple>();
  return {.name = "query " + std::to_string(number),
          .file = {},
          .shape = shape_of(arrays[0].cast<Points>(), arrays[1].cast<Triangles>(), arrays[2].cast<Points>())};
}

std::vector<SearchQuery> queries_of(const py::list& query_list) {
  std::vector<SearchQuery> queries;
  for (const py::handle& one : query_list) queries.push_back(query_of(one, queries.size()));
  return queries;
}

/// Throws InputError if the page would overwrite an input or an existing file.
void check_page(const NativeIndex& opened, const py::list& query_list, const fs::path& page, bool replace) {
  std::vector<fs::path> inputs{opened.index.file};
  for (const SearchQuery& query : queries_of(query_list)) inputs.push_back(query.file);
  for (const IndexedFile& model : opened.index.contents.models) {
    inputs.push_back(opened.index.collection.file(model.path));
  }
  const OutputFile output{.path = page, .what = "page", .extensions = page_extensions};
  check_output_files(inputs, {&output, 1}, replace);
}

/// Returns per query its name, the model that it equals (or None), the models found, their distances, and the reason
/// for a missing answer. With a page, the page's text follows.
py::tuple answer(NativeIndex& opened, const py::list& query_list, std::size_t count, bool rerank,
                 const std::optional<std::string>& page_title, const std::string& up, int threads,
                 const PythonProgress& progress) {
  const auto up_axis = known_word<UpAxis>("up", up);
  const std::vector<SearchQuery> queries = queries_of(query_list);
  std::vector<SearchAnswer> answers;
  std::string page;
  Cancellation cancellation;
  const RunControl control = interruptible_control(threads, cancellation, progress);
  opened.notes.clear();
  run_interruptibly(cancellation, [&] {
    answers = search(opened.index, queries, {.count = count, .rerank = rerank}, control, *opened.cache, opened.notes);
    if (page_title) page = page_of_answers(opened.index, queries, answers, *page_title, up_axis, control);
  });
  py::list found;
  for (const SearchAnswer& one : answers) {
    std::vector<Eigen::Index> models;
    Eigen::VectorXd distances(std::ssize(one.nearest));
    for (const RankedModel& model : one.nearest) {
      distances[std::ssize(models)] = model.distance;
      models.push_back(model.model);
    }
    found.append(py::make_tuple(one.query, one.member, models, array_of(std::move(distances)), one.failure));
  }
  return py::make_tuple(found, page);
}

std::vector<std::pair<std::string, std::string>> named_failures(const NativeIndex& opened) {
  std::vector<std::pair<std::string, std::string>> failures;
  for (const IndexedFile& file : opened.index.contents.failures) failures.emplace_back(file.id, file.failure);
  return failures;
}

/// Returns the names of the models and their files.
std::vector<std::pair<std::string, std::string>> named_files(const NativeIndex& opened) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const IndexedFile& model : opened.index.contents.models) {
    files.emplace_back(model.id, opened.index.collection.file(model.path).string());
  }
  return files;
}

}  // namespace

void bind_search(py::module_& module) {
  py::class_<MethodRequest>(module, "MethodRequest")
      .def(py::init([](const std::string& configuration, const std::string& source, const std::string& signature,
                       bool articulated) {
        return MethodRequest{configuration, source, signature,
                             articulated ? RecommendedMethod::articulated : RecommendedMethod::any};
      }));
  py::class_<NativeIndex>(module, "Index")
      .def_readonly("notes", &NativeIndex::notes)
      .def_readonly("left_out", &NativeIndex::left_out)
      .def_property_readonly("file", [](const NativeIndex& opened) { return opened.index.file.string(); })
      .def_property_readonly("signature", [](const NativeIndex& opened) { return opened.index.method.name; })
      .def("models", &named_files)
      .def("failures", &named_failures)
      .def("check_page", &check_page)
      .def("search", &answer);
  module.def("write_page", [](const fs::path& page, const std::string& text) { write_file_atomically(page, text); });
  module.def("open_index", &open);
}

}  // namespace shapegauge
