// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/search/search_method.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/experiments/signatures/signature_tables.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Version of the index format; increment when an index changes.
constexpr int index_version = 6;

bool is_reranked(const SignatureConfiguration& signature) {
  return signature.derived && std::holds_alternative<RerankSettings>(signature.derived->settings);
}

/// Returns why the signature is unsuitable for searches; empty if it is suitable.
std::string why_not_searchable(const std::vector<SignatureConfiguration>& signatures, std::size_t chosen) {
  const SignatureConfiguration& signature = signatures[chosen];
  if (!signature.derived) return "";
  if (is_reranked(signature)) return "it is re-ranked; choose the signature that it re-ranks, with `rerank=true`";
  if (!std::holds_alternative<SumSettings>(signature.derived->settings))
    return "it fuses ranks of a whole data set; choose a sum";
  for (const std::size_t part : signature.parts) {
    if (!signatures[part].derived) continue;
    return fmt::format("its term \"{}\" combines other signatures; add these to the sum instead",
                       signatures[part].name);
  }
  return "";
}

std::size_t named_signature(const std::vector<SignatureConfiguration>& signatures, const std::string& name,
                            const std::string& source) {
  std::vector<std::string> names;
  for (const SignatureConfiguration& one : signatures) names.push_back(one.name);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw InputError(fmt::format("{}: {}", source, unknown_word_message("signature", name, names)));
  }
  const auto chosen = static_cast<std::size_t>(found - names.begin());
  const std::string why = why_not_searchable(signatures, chosen);
  if (why.empty()) return chosen;
  throw InputError(fmt::format("{}: the signature \"{}\" is not suitable for searches: {}", source, name, why));
}

/// Returns the signature of that name; for an empty name, the last suitable one.
std::size_t chosen_signature(const std::vector<SignatureConfiguration>& signatures, const std::string& name,
                             const std::string& source) {
  if (!name.empty()) return named_signature(signatures, name, source);
  for (std::size_t i = signatures.size(); i-- > 0;) {
    if (why_not_searchable(signatures, i).empty()) return i;
  }
  throw InputError(fmt::format(
      "{}: all signatures are re-ranked or fused, which searches do not support; add one that is not", source));
}

/// Inserts the index of a signature, and those of the signatures that it is made from, into `needed`.
void add_with_parts(const std::vector<SignatureConfiguration>& signatures, std::size_t one,
                    std::set<std::size_t>& needed) {
  if (!needed.insert(one).second) return;
  for (const std::size_t part : signatures[one].parts) add_with_parts(signatures, part, needed);
}

/// Returns the settings of the first diffusion of the signature, or defaults.
DiffusionOptions diffusion_of(const std::vector<SignatureConfiguration>& signatures, std::size_t chosen) {
  for (const SignatureConfiguration& one : signatures) {
    if (!is_reranked(one) || one.parts.front() != chosen) continue;
    const auto& rerank = std::get<RerankSettings>(one.derived->settings);
    if (rerank.method->name == "diffusion") return diffusion_options(rerank.values);
  }
  return {.neighbours = {}};
}

}  // namespace

std::string SearchMethod::key() const {
  // Cache keys of a fixed shape represent all settings, versions and the program.
  const std::string shape = shape_key({.sha256 = "", .file = "any.off", .id = "", .index = 0},
                                      configuration.preparation, configuration.perturbations, configuration.seed);
  Json depends_on{
      {"index", index_version}, {"terms", terms}, {"distances", Json::array()}, {"signatures", Json::array()}};
  for (const std::size_t term : terms) {
    depends_on["distances"].push_back(distance_between(configuration.signatures[term], configuration).name);
  }
  depends_on["distances"].push_back(distances_version);
  depends_on["histogram_version"] = histogram_version;
  for (const SignatureConfiguration& signature : configuration.signatures) {
    std::vector<std::string> fields;
    if (signature.field) fields.push_back(field_key(shape, *signature.field));
    if (signature.descriptor) {
      for (const Field& field : signature.descriptor->fields) fields.push_back(field_key(shape, field));
      fields.push_back(features_key(shape, *signature.descriptor, fields, ""));
    }
    depends_on["signatures"].push_back({{"keys", fields}, {"parts", signature.parts}});
  }
  depends_on["settings"] = to_json(configuration.signatures);
  return sha256(json_text(depends_on));
}

SearchMethod search_method(Json document, const std::string& source, const std::string& requested) {
  if (document.is_object()) {
    for (const char* key : {"perturbations", "evaluation", "protocol", "keep_distances"}) document.erase(key);
    document["dataset"] = {{"layout", "folders"}, {"root", "."}};
    document["report"] = false;
    document["on_error"] = "skip";
  }
  SearchMethod method;
  method.configuration = configuration_from_json(document, source, ".");
  std::vector<SignatureConfiguration>& signatures = method.configuration.signatures;
  const std::size_t chosen = chosen_signature(signatures, requested, source);
  method.name = signatures[chosen].name;
  method.diffusion = diffusion_of(signatures, chosen);

  std::set<std::size_t> needed;
  add_with_parts(signatures, chosen, needed);
  const auto new_index = [&](std::size_t signature) {
    return static_cast<std::size_t>(std::distance(needed.begin(), needed.find(signature)));
  };
  std::vector<SignatureConfiguration> retained;
  for (const std::size_t i : needed) {
    SignatureConfiguration& signature = retained.emplace_back(std::move(signatures[i]));
    for (std::size_t& part : signature.parts) part = new_index(part);
  }
  signatures = std::move(retained);
  const std::size_t index = new_index(chosen);
  if (const auto& derived = signatures[index].derived) {
    method.terms = signatures[index].parts;
    method.sum = std::get<SumSettings>(derived->settings);
  } else {
    method.terms = {index};
    method.sum = {.weights = {1}, .options = {.scale = DistanceScale::none}};
  }
  return method;
}

SearchMethod read_search_method(const fs::path& file, std::span<const std::string> overrides,
                                const std::string& signature) {
  return search_method(read_retrieval_document(file, overrides), file.string(), signature);
}

std::string recommended_file(RecommendedMethod method) {
  return method == RecommendedMethod::articulated ? "recommended_articulated.json" : "recommended.json";
}

SearchMethod recommended_search_method(RecommendedMethod method) {
  const std::string file = recommended_file(method);
  return search_method(parse_json(recommended_configuration(method), file), file);
}

}  // namespace shapegauge
