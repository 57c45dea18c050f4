// SPDX-License-Identifier: Apache-2.0
#include "io/faults/spec_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/text/one_line.hpp"

namespace torquewright::io {
namespace {

constexpr std::size_t kMostSentences = 1000;
constexpr std::size_t kLongestSentence = 4000;  // bytes

/// The text with control characters written as \u00XX, and U+FFFD for what is no UTF-8.
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
  return one_line(line);
}

std::string sentence(const Fault& fault) {
  const std::string where = fault.path.empty() ? fault.file : fault.file + "#" + fault.path;
  return on_one_line(where + ": " + fault.message);
}

/// A line that a terminal and its reader can bear, cut between characters.
std::string of_bearable_length(std::string line) {
  if (line.size() <= kLongestSentence) return line;
  std::size_t end = kLongestSentence;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  return line.substr(0, end) + " ...";
}

std::string sentences(const std::vector<Fault>& faults) {
  if (faults.empty()) throw std::invalid_argument("a SpecError needs at least one fault");
  std::string lines;
  const std::size_t shown = std::min(faults.size(), kMostSentences);
  for (std::size_t i = 0; i < shown; ++i) {
    if (!lines.empty()) lines += '\n';
    lines += of_bearable_length(sentence(faults[i]));
  }
  if (shown < faults.size()) {
    lines += fmt::format("\n{}: and {} faults more", faults[shown].file, faults.size() - shown);
  }
  return lines;
}

}  // namespace

SpecError::SpecError(std::vector<Fault> faults)
    : std::runtime_error(sentences(faults)), faults_(std::move(faults)) {}

}  // namespace torquewright::io
