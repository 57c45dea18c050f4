// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/protobuf.hpp"

#include <bit>
#include <cstring>
#include <stdexcept>

namespace torquewright::hopper {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written lowest byte first");

constexpr int kVarint = 0;
constexpr int kEightBytes = 1;
constexpr int kBytes = 2;
constexpr int kFourBytes = 5;

}  // namespace

void ProtobufWriter::varint(std::uint64_t value) {
  for (; value >= 128; value >>= 7) text_ += static_cast<char>(value | 128);
  text_ += static_cast<char>(value);
}

void ProtobufWriter::key(int field, int type) {
  varint(static_cast<std::uint64_t>(field) << 3 | static_cast<std::uint64_t>(type));
}

void ProtobufWriter::integer(int field, std::int64_t value) {
  key(field, kVarint);
  varint(static_cast<std::uint64_t>(value));
}

void ProtobufWriter::number(int field, float value) {
  key(field, kFourBytes);
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  text_.append(bytes, sizeof value);
}

void ProtobufWriter::bytes(int field, std::string_view value) {
  key(field, kBytes);
  varint(value.size());
  text_ += value;
}

std::uint64_t ProtobufReader::varint() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const auto byte = static_cast<unsigned char>(take(1).front());
    value |= static_cast<std::uint64_t>(byte & 127) << shift;
    if (byte < 128) return value;
  }
  throw std::invalid_argument("a whole number of more than 64 bits");
}

std::string_view ProtobufReader::take(std::uint64_t count) {
  if (count > rest_.size()) throw std::invalid_argument("it ends in the middle of a field");
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

bool ProtobufReader::next(ProtobufField& field) {
  if (rest_.empty()) return false;
  const std::uint64_t key = varint();
  field = {};
  field.number = static_cast<int>(key >> 3 & 0x1fffffff);
  const auto type = static_cast<int>(key & 7);
  if (type == kVarint) {
    field.integer = static_cast<std::int64_t>(varint());
  } else if (type == kBytes) {
    field.is_bytes = true;
    field.bytes = take(varint());
  } else if (type == kFourBytes) {
    field.real = number_in<float>(take(4), 0);
  } else if (type == kEightBytes) {
    field.real = number_in<double>(take(8), 0);
  } else {
    throw std::invalid_argument("a field of a form that does not exist");
  }
  return true;
}

bool ProtobufReader::next_packed(std::int64_t& value) {
  if (rest_.empty()) return false;
  value = static_cast<std::int64_t>(varint());
  return true;
}

template <typename Number>
Number number_in(std::string_view bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at * sizeof number, sizeof number);
  return number;
}

template float number_in<float>(std::string_view, std::size_t);
template double number_in<double>(std::string_view, std::size_t);

}  // namespace torquewright::hopper
