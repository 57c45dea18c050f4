// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/step_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

#include "io/documents/provenance.hpp"

namespace torquewright::report {
namespace {

constexpr std::string_view kTimeStamp = "1970-01-01T00:00:00";
constexpr std::string_view kSchema = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }";

/// Without zeros at the end, with the point that the format asks for; no minus before 0.
std::string trimmed(std::string digits) {
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits == "-0." ? "0." : digits;
}

/// Takes the first character of UTF-8 off the text; what is none, as its byte.
std::uint32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  std::uint32_t code = byte(0);
  if (length > 1 && length <= text.size()) {
    code &= 0xFFU >> (length + 1);
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3FU);
    text.remove_prefix(length);
  } else {
    text.remove_prefix(1);
  }
  return code;
}

}  // namespace

StepId StepFile::add(std::string_view entity) {
  fmt::format_to(std::back_inserter(data_), "#{}={};\n", ++count_, entity);
  return {count_};
}

std::string StepFile::finished() const {
  const std::string program = fmt::format("Torquewright {}", io::tool_version());
  return fmt::format(
      "ISO-10303-21;\nHEADER;\n"
      "FILE_DESCRIPTION((''),'2;1');\n"
      "FILE_NAME({},'{}',(''),(''),{},{},'');\n"
      "FILE_SCHEMA(({}));\n"
      "ENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
      step_string(name_), kTimeStamp, step_string(program), step_string(program),
      step_string(kSchema), data_);
}

std::string step_reference(StepId id) { return fmt::format("#{}", id.number); }

std::string step_list(const std::vector<StepId>& ids) {
  std::string list;
  for (const StepId id : ids) list += (list.empty() ? "(#" : ",#") + std::to_string(id.number);
  return list + ")";
}

std::string step_length(double length_mm) { return trimmed(fmt::format("{:.9f}", length_mm)); }

std::string step_number(double number) { return trimmed(fmt::format("{:.15f}", number)); }

std::string step_string(std::string_view text) {
  std::string quoted = "'";
  while (!text.empty()) {
    const std::uint32_t code = take_character(text);
    if (code == '\'' || code == '\\') {
      quoted.append(2, static_cast<char>(code));
    } else if (code >= 0x20 && code < 0x7F) {
      quoted += static_cast<char>(code);
    } else {
      quoted += fmt::format("\\X4\\{:08X}\\X0\\", code);
    }
  }
  return quoted + "'";
}

}  // namespace torquewright::report
