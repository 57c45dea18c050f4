// SPDX-License-Identifier: Apache-2.0
// The wire format of Protocol Buffers (protobuf.dev, "Encoding"), as far as ONNX uses it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace torquewright::hopper {

/// Writes the fields of one message, one behind the other.
class ProtobufWriter {
 public:
  void integer(int field, std::int64_t value);
  void number(int field, float value);
  void bytes(int field, std::string_view value);  ///< A text, a message, packed numbers.

  const std::string& text() const { return text_; }

 private:
  void key(int field, int type);
  void varint(std::uint64_t value);

  std::string text_;
};

/// A field as it is read.
struct ProtobufField {
  int number = 0;
  bool is_bytes = false;
  std::int64_t integer = 0;  ///< Of whole numbers.
  double real = 0.0;         ///< Of those of 4 or 8 bytes.
  std::string_view bytes;    ///< Of all else.
};

/// Reads the fields of one message. Throws std::invalid_argument with a sentence where the bytes
/// are none.
class ProtobufReader {
 public:
  explicit ProtobufReader(std::string_view bytes) : rest_(bytes) {}

  /// False where there are no more.
  bool next(ProtobufField& field);

  /// The next whole number of those that are packed into bytes.
  bool next_packed(std::int64_t& value);

 private:
  std::uint64_t varint();
  std::string_view take(std::uint64_t count);

  std::string_view rest_;
};

/// Numbers of the machine's own form in bytes, lowest byte first.
template <typename Number>
Number number_in(std::string_view bytes, std::size_t at);

}  // namespace torquewright::hopper
