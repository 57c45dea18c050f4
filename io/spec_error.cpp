// SPDX-License-Identifier: Apache-2.0
#include "io/spec_error.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace torquewright::io {
namespace {

/// The text with control characters written as \u00XX.
std::string on_one_line(std::string_view text) {
  std::string line;
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (code < 0x20 || code == 0x7f) {
      line += fmt::format("\\u{:04x}", code);
    } else {
      line += character;
    }
  }
  return line;
}

std::string sentence(const Fault& fault) {
  const std::string where = fault.path.empty() ? fault.file : fault.file + "#" + fault.path;
  return on_one_line(where + ": " + fault.message);
}

std::string sentences(const std::vector<Fault>& faults) {
  if (faults.empty()) throw std::invalid_argument("a SpecError needs at least one fault");
  std::string lines;
  for (const Fault& fault : faults) {
    if (!lines.empty()) lines += '\n';
    lines += sentence(fault);
  }
  return lines;
}

}  // namespace

SpecError::SpecError(std::vector<Fault> faults)
    : std::runtime_error(sentences(faults)), faults_(std::move(faults)) {}

}  // namespace torquewright::io
