// SPDX-License-Identifier: Apache-2.0
#include "io/table_forms/npy_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace torquewright::io {
namespace {

/// What stands behind a key, without blanks before it; empty where the key is missing.
std::string_view value_of(std::string_view dictionary, std::string_view key) {
  const std::size_t found = dictionary.find(key);
  if (found == std::string_view::npos) return "";
  std::string_view rest = dictionary.substr(found + key.size());
  const std::size_t first = rest.find_first_not_of(": ");
  return first == std::string_view::npos ? "" : rest.substr(first);
}

/// (4700, 12)
std::vector<std::size_t> numbers_in(std::string_view tuple) {
  std::vector<std::size_t> numbers;
  const char* at = tuple.data();
  const char* const end = at + std::min(tuple.find(')'), tuple.size());
  while (at != end) {
    std::size_t number = 0;
    const auto parsed = std::from_chars(at, end, number);
    if (parsed.ec == std::errc()) numbers.push_back(number);
    at = parsed.ec == std::errc() ? parsed.ptr : at + 1;
  }
  return numbers;
}

std::string name_of_kind(char kind) {
  switch (kind) {
    case 'U':
    case 'S':
      return "text";
    case 'O':
      return "Python objects";
    case 'c':
      return "complex numbers";
    case 'M':
    case 'm':
      return "dates";
    default:
      return fmt::format("numbers of the type {}", kind);
  }
}

bool is_known_size(char kind, std::size_t bytes) {
  if (kind == 'b') return bytes == 1;
  if (kind == 'f') return bytes == 4 || bytes == 8;
  return bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
}

/// '<f8'
void read_type(std::string_view descr, NpyHeader& header) {
  if (!descr.starts_with('\'') || descr.size() < 4) {
    header.is_no_number = "records of several fields";
    return;
  }
  descr.remove_prefix(1);
  header.is_swapped = descr.front() == '>';
  header.kind = descr[1];
  std::from_chars(descr.data() + 2, descr.data() + descr.size(), header.bytes);
  if (std::string_view("fiub").find(header.kind) == std::string_view::npos) {
    header.is_no_number = name_of_kind(header.kind);
  } else if (!is_known_size(header.kind, header.bytes)) {
    header.is_no_number = fmt::format("numbers of {} bytes", header.bytes);
  }
}

template <class Number>
void append(const char* bytes, std::string& text) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  // As a number, where a letter is meant by the type of one byte.
  fmt::format_to(std::back_inserter(text), "{}", +number);
}

}  // namespace

NpyHeader npy_header(std::string_view dictionary) {
  NpyHeader header;
  read_type(value_of(dictionary, "'descr'"), header);
  header.is_by_column = value_of(dictionary, "'fortran_order'").starts_with("True");
  header.shape = numbers_in(value_of(dictionary, "'shape'"));
  return header;
}

void append_number(const NpyHeader& header, const char* at, std::string& text) {
  char bytes[sizeof(double)];
  std::memcpy(bytes, at, header.bytes);
  if (header.is_swapped) std::reverse(bytes, bytes + header.bytes);
  const bool has_sign = header.kind == 'i';
  if (header.kind == 'f')
    return header.bytes == 4 ? append<float>(bytes, text) : append<double>(bytes, text);
  switch (header.bytes) {
    case 1:
      return has_sign ? append<std::int8_t>(bytes, text) : append<std::uint8_t>(bytes, text);
    case 2:
      return has_sign ? append<std::int16_t>(bytes, text) : append<std::uint16_t>(bytes, text);
    case 4:
      return has_sign ? append<std::int32_t>(bytes, text) : append<std::uint32_t>(bytes, text);
    default:
      return has_sign ? append<std::int64_t>(bytes, text) : append<std::uint64_t>(bytes, text);
  }
}

}  // namespace torquewright::io
