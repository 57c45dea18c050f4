// SPDX-License-Identifier: Apache-2.0
#include "io/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace torquewright::io {

namespace {

using Digest = std::array<unsigned char, 32>;

void require_success(int result) {
  if (result != 1) throw std::runtime_error("the system's SHA-256 is not available");
}

std::string hexadecimal(const Digest& digest) {
  std::string text;
  for (const unsigned char byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest{};
  require_success(
      EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr));
  return hexadecimal(digest);
}

struct Sha256::Context {
  EVP_MD_CTX* value = EVP_MD_CTX_new();
  ~Context() { EVP_MD_CTX_free(value); }
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  require_success(EVP_DigestInit_ex(context_->value, EVP_sha256(), nullptr));
}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  require_success(EVP_DigestUpdate(context_->value, bytes.data(), bytes.size()));
}

std::string Sha256::digest() {
  Digest digest{};
  require_success(EVP_DigestFinal_ex(context_->value, digest.data(), nullptr));
  return hexadecimal(digest);
}

}  // namespace torquewright::io
