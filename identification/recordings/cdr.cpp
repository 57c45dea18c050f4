// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/cdr.hpp"

#include <algorithm>
#include <bit>

namespace torquewright::identification {
namespace {

constexpr std::size_t kFormBytes = 4;
constexpr unsigned kFirstOfXcdr2 = 6;  // in which eight bytes begin at multiples of four

}  // namespace

Cdr::Cdr(std::string_view bytes) {
  if (bytes.size() < kFormBytes) return;
  form_ = static_cast<unsigned char>(bytes[0]) * 256U + static_cast<unsigned char>(bytes[1]);
  bytes_ = bytes.substr(kFormBytes);
}

std::string_view Cdr::take(std::size_t size, std::size_t alignment) {
  const std::size_t begin = (at_ + alignment - 1) / alignment * alignment;
  is_short_ = is_short_ || begin > bytes_.size() || size > bytes_.size() - begin;
  if (is_short_) return "";
  at_ = begin + size;
  return bytes_.substr(begin, size);
}

std::uint64_t Cdr::number(std::size_t size) {
  const std::size_t alignment = form_ >= kFirstOfXcdr2 ? std::min<std::size_t>(size, 4) : size;
  const std::string_view digits = take(size, alignment);
  const bool is_least_first = form_ % 2 == 1;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t place = is_least_first ? digits.size() - 1 - i : i;
    value = 256 * value + static_cast<unsigned char>(digits[place]);
  }
  return value;
}

std::uint32_t Cdr::whole_number() { return static_cast<std::uint32_t>(number(4)); }

/// Of a sequence: no more than fit into what is left.
std::size_t Cdr::count(std::size_t least_size) {
  const std::size_t stated = whole_number();
  is_short_ = is_short_ || stated > (bytes_.size() - at_) / least_size;
  return is_short_ ? 0 : stated;
}

/// Its length counts the zero at its end.
std::string Cdr::text() {
  std::string_view letters = take(whole_number(), 1);
  if (letters.ends_with('\0')) letters.remove_suffix(1);
  return std::string(letters);
}

void Cdr::texts(std::vector<std::string>& texts) {
  texts.resize(count(4));
  for (std::string& each : texts) each = text();
}

void Cdr::numbers(std::vector<double>& numbers) {
  numbers.resize(count(8));
  for (double& each : numbers) each = std::bit_cast<double>(number(8));
}

}  // namespace torquewright::identification
