// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/script_policy.hpp"

#include <fmt/format.h>

#include <vector>

#include "io/files/sha256.hpp"

namespace torquewright::report {
namespace {

/// RFC 4648, of hexadecimal digits.
std::string base64_of_hex(const std::string& hex) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  unsigned held = 0;
  int bits = 0;
  for (const char digit : hex) {
    held = (held << 4U) | static_cast<unsigned>(std::stoi(std::string(1, digit), nullptr, 16));
    bits += 4;
    if (bits < 6) continue;
    bits -= 6;
    text += kDigits[(held >> static_cast<unsigned>(bits)) & 63U];
  }
  if (bits > 0) text += kDigits[(held << static_cast<unsigned>(6 - bits)) & 63U];
  while (text.size() % 4 != 0) text += '=';
  return text;
}

}  // namespace

std::string script_policy(std::string_view script) {
  return fmt::format(
      "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{}'; base-uri 'none'; "
      "form-action 'none'",
      base64_of_hex(io::sha256(script)));
}

}  // namespace torquewright::report
