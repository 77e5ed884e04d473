#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

/// One setting of a descriptor: a member of its options, whose default is that of the struct, and what it may be. This
/// is the one place that knows; checks, schemas and reference pages come from it. See option_of().
template <typename Options>
struct DescriptorOption {
  std::string_view name;
  double (*value)(const Options&);
  void (*set)(Options&, double);
  bool whole;
  double lowest;  ///< no value is below; a bool is 0 or 1
  double highest;
  std::string_view meaning;
};

/// The options and the type of a pointer to a member.
template <typename Member>
struct MemberOf;
template <typename OptionsOf, typename ValueOf>
struct MemberOf<ValueOf OptionsOf::*> {
  using Options = OptionsOf;
  using Value = ValueOf;
};

/// The setting that a member (an int, a double or a bool) of a struct of options is.
template <auto member>
constexpr auto option_of(std::string_view name, double lowest, double highest, std::string_view meaning) {
  using Options = typename MemberOf<decltype(member)>::Options;
  using Value = typename MemberOf<decltype(member)>::Value;
  return DescriptorOption<Options>{.name = name,
                                   .value = [](const Options& options) { return static_cast<double>(options.*member); },
                                   .set = [](Options& options, double to) { options.*member = static_cast<Value>(to); },
                                   .whole = !std::is_same_v<Value, double>,
                                   .lowest = lowest,
                                   .highest = highest,
                                   .meaning = meaning};
}

/// Settings by name; those that are not given have their defaults.
using DescriptorSettings = std::map<std::string, double, std::less<>>;

/// A setting without the type of the options that it belongs to.
struct DescriptorParameter {
  std::string_view name;
  double fallback;
  double lowest;
  double highest;
  bool whole;  ///< only whole numbers
  std::string_view meaning;
};

/// What a descriptor is computed from.
struct DescriptorInput {
  const Shape& shape;                   ///< prepared, of unit area
  std::span<const ScalarField> fields;  ///< at the same samples; none where the descriptor takes none
};

/// What a descriptor must know of the whole data set before it can describe a shape: a codebook, for example. Empty for
/// most.
using LearntFeatures = Eigen::MatrixXf;

/// A descriptor: from a shape, or fields on it, to features of a length that only the settings decide, and the distance
/// between two such. Functions throw InputError for settings out of range and for what cannot be described.
struct Descriptor {
  std::string_view name;
  std::string_view meaning;
  std::span<const DescriptorParameter> parameters;
  std::size_t fewest_fields = 0;
  std::size_t most_fields = 0;
  Eigen::VectorXf (*describe)(const DescriptorInput&, const LearntFeatures&, const DescriptorSettings&) = nullptr;
  DistanceFunction distance = nullptr;
  /// What is learnt from all shapes before; nullptr: nothing.
  LearntFeatures (*learn)(std::span<const DescriptorInput>, const DescriptorSettings&) = nullptr;
};

/// All descriptors. A new one is one file in this folder and one line in descriptor.cpp.
std::span<const Descriptor> descriptors();

/// The descriptor of that name. Throws InputError, naming those there are.
const Descriptor& descriptor(std::string_view name);

/// All distances between shapes with such features, one shape a row; in parallel, the same bytes for any number of
/// threads. Throws InputError for a feature that is not finite.
DistanceMatrix descriptor_distances(const Descriptor& of, const Signatures& features);

/// Throws InputError where the value is not one that the parameter may have.
void require_allowed(std::string_view descriptor, const DescriptorParameter& parameter, double value);

/// The option as a parameter with a default.
template <typename Options>
constexpr DescriptorParameter as_parameter(const DescriptorOption<Options>& option, double fallback) {
  return {option.name, fallback, option.lowest, option.highest, option.whole, option.meaning};
}

/// The parameters of a table of options.
template <typename Options, std::size_t count>
constexpr std::array<DescriptorParameter, count> parameters_of(
    const std::array<DescriptorOption<Options>, count>& table) {
  const Options defaults = {};
  std::array<DescriptorParameter, count> parameters = {};
  for (std::size_t i = 0; i < count; ++i) parameters[i] = as_parameter(table[i], table[i].value(defaults));
  return parameters;
}

/// Throws InputError where a value of the options is out of the table's bounds.
template <typename Options, std::size_t count>
void check_options(std::string_view descriptor, const std::array<DescriptorOption<Options>, count>& table,
                   const Options& options) {
  for (const auto& option : table) require_allowed(descriptor, as_parameter(option, 0), option.value(options));
}

/// The options that the settings say. Throws InputError for a name that is not in the table and a value out of bounds.
template <typename Options, std::size_t count>
Options options_from(std::string_view descriptor, const std::array<DescriptorOption<Options>, count>& table,
                     const DescriptorSettings& settings) {
  Options options;
  for (const auto& [name, value] : settings) {
    const auto option = std::ranges::find(table, std::string_view(name), &DescriptorOption<Options>::name);
    if (option == table.end()) {
      throw InputError("the descriptor " + std::string(descriptor) + " has no setting \"" + name + "\"");
    }
    require_allowed(descriptor, as_parameter(*option, 0), value);
    option->set(options, value);
  }
  return options;
}

}  // namespace shapegauge
