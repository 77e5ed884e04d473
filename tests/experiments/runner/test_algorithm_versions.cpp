#include <bit>
#include <cstdint>
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/files/sha256.h"
#include "shapegauge/experiments/results/manifest.h"
#include "shapegauge/experiments/runner/cache_records.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/histogram.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

using Json = nlohmann::json;

/// Where the hashes below were taken. Elsewhere the last bits may be others, which says nothing of the algorithms.
bool is_as_recorded() {
  return processor() == "x86-64 sse4.2 avx avx2 fma avx512f avx512dq avx512vl" && compiler() == "GNU 12.2.0" &&
         build_type() == "Release";
}

template <typename Numbers>
std::string hash_of(const Numbers& numbers) {
  std::string text;
  for (const auto number : numbers) text += std::to_string(std::bit_cast<std::uint64_t>(static_cast<double>(number)));
  return sha256(text).substr(0, 16);
}

/// A closed, a bent and an open surface.
std::vector<Shape> shapes() {
  Shape open = test_shapes::box({1, 2, 0.3}, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 4, Eigen::NoChange);
  return {test_shapes::capsule(0.2, 2, 16, 6), test_shapes::torus(1, 0.3, 12, 8), open};
}

/// What a kind of field gives: its versions, and a hash of the values on the shapes.
struct Recorded {
  Json settings;
  Json versions;
  std::string hash;
};

TEST(AlgorithmVersions, WithOtherValuesComesAnotherVersion) {
  if (!is_as_recorded()) GTEST_SKIP() << "the hashes were taken with another processor, compiler or build type";
  const std::vector<Recorded> fields{
      {{{"type", "offset_sdf"}, {"offset", 0.05}}, {{"offset_sdf", 3}}, "3f71eb3e0bac2faa"},
      {{{"type", "offset_sdf"}, {"offset", "auto"}}, {{"offset_sdf", 3}, {"automatic_offset", 1}}, "0d13dc0b9dbfd6ec"},
      {{{"type", "cone_sdf"}, {"at", "vertices"}}, {{"cone_sdf", 2}}, "e62d620270aa17ec"},
      {{{"type", "cone_sdf"}, {"engine", "cgal"}}, {{"cone_sdf", 2}}, "25dbfe15ab2dcd0c"},
      {{{"type", "cone_sdf"}, {"at", {{"surface", 50}}}}, {{"cone_sdf", 2}}, "eeae307b8d5651c8"}};
  for (const Recorded& recorded : fields) {
    const Field field = make_field(recorded.settings);
    std::string hashes;
    for (const Shape& shape : shapes()) {
      const PreparedShape prepared = prepare_shape(shape, {});
      const Samples samples = take_samples(prepared.shape, field.samples);
      FieldSource source(prepared.shape);
      const FieldValues computed = field.compute(source, samples, false);
      hashes += hash_of(computed.values) + hash_of(samples.weights);
    }
    EXPECT_EQ(sha256(hashes).substr(0, 16), recorded.hash)
        << recorded.settings << " gives other values than before: raise the version of the algorithm that changed "
        << "(offset_sdf_version, samples_version, preparation_version, ...), so that caches give none of the old ones, "
        << "and then correct what is recorded here";
    EXPECT_EQ(field.versions, recorded.versions);
  }
}

TEST(AlgorithmVersions, WithOtherHistogramsComesAnotherVersion) {
  if (!is_as_recorded()) GTEST_SKIP() << "the hash was taken with another processor, compiler or build type";
  const ScalarField field{.values = Eigen::VectorXd::LinSpaced(40, 0.1, 1.3).array().square(),
                          .weights = Eigen::VectorXd::LinSpaced(40, 1, 2)};
  const Eigen::VectorXf plain = histogram(field, {.low = 0, .high = 1.7}, {.bins = 7});
  const Eigen::VectorXf smooth = histogram(field, {.low = 0, .high = 1.7}, {.bins = 7, .smoothing_bins = 1.5});
  EXPECT_EQ(hash_of(plain) + hash_of(smooth), "b2a42a1950c87390707f4b17b301a33e")
      << "raise histogram_version and correct what is recorded here";
  EXPECT_EQ(histogram_version, 1);
}

TEST(AlgorithmVersions, WithOtherDistancesComesAnotherVersion) {
  if (!is_as_recorded()) GTEST_SKIP() << "the hash was taken with another processor, compiler or build type";
  Signatures signatures(5, 37);
  for (Eigen::Index i = 0; i < signatures.size(); ++i) signatures.data()[i] = 1.0F / static_cast<float>(i + 3);
  const DistanceMatrix distances = distance_matrix(signatures, "l1");
  EXPECT_EQ(hash_of(distances.reshaped()), "b64ff96411d0b11a")
      << "raise distances_version and correct what is recorded here";
  EXPECT_EQ(distances_version, 2);
}

}  // namespace
}  // namespace shapegauge
