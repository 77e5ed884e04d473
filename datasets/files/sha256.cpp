// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/sha256.h"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <openssl/evp.h>
#include <stdexcept>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"

namespace shapegauge {

namespace {

/// Incremental SHA-256.
class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new()) {
    check(context_ != nullptr ? EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) : 0);
  }
  void add(std::string_view bytes) { check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size())); }
  std::string text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), &length));
    std::string text;
    for (unsigned int i = 0; i < length; ++i) text += fmt::format("{:02x}", digest.at(i));
    return text;
  }

 private:
  static void check(int success) {
    if (success != 1) throw std::runtime_error("libcrypto cannot compute SHA-256");
  }

  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context_;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.text();
}

std::string sha256_of_file(const std::filesystem::path& path) {
  constexpr std::size_t piece = 1 << 20;
  // Throws for a path that is not a file, or empty.
  const std::string beginning = read_file_bytes(path, piece);
  Digest digest;
  digest.add(beginning);
  if (beginning.size() < piece) return digest.text();
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(piece));
  std::string bytes(piece, '\0');
  while (file.read(bytes.data(), static_cast<std::streamsize>(piece)), file.gcount() > 0) {
    digest.add(std::string_view(bytes).substr(0, static_cast<std::size_t>(file.gcount())));
  }
  if (!file.eof()) throw InputError(fmt::format("cannot read {}", path.string()));
  return digest.text();
}

std::string sha256_of_file_if_readable(const std::filesystem::path& path) {
  try {
    return sha256_of_file(path);
  } catch (const InputError&) {
    return {};
  }
}

std::string sha256_of_shape(const ShapeSource& source) {
  const std::string hash = sha256(source.bytes);
  std::string all = hash;
  try {
    for (const std::string& file : shape_neighbours(source)) {
      all += fmt::format("\n{} {}", sha256_of_file(source.neighbour(file)), file);
    }
  } catch (const InputError&) {  // NOLINT(bugprone-empty-catch): reported when the shape is read
  }
  return all == hash ? hash : sha256(all);
}

std::string sha256_if_readable(const std::filesystem::path& path) {
  try {
    return sha256_of_shape(read_shape_source(path));
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace shapegauge
