// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/script_policy.hpp"

#include <fmt/format.h>

#include "io/files/sha256.hpp"
#include "src/report/parts/base64.hpp"

namespace torquewright::report {
namespace {

std::string bytes_of_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

}  // namespace

std::string script_policy(const std::vector<std::string_view>& scripts) {
  std::string sources;
  for (const std::string_view script : scripts) {
    sources += fmt::format(" 'sha256-{}'", base64(bytes_of_hex(io::sha256(script))));
  }
  return fmt::format(
      "default-src 'none'; style-src 'unsafe-inline'; script-src{}; base-uri 'none'; "
      "form-action 'none'",
      sources);
}

}  // namespace torquewright::report
