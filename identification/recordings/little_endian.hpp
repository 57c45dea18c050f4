// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace torquewright::identification {

/// Reads fields one behind another, least byte first. What would lie beyond the end is absent, and
/// so is all that follows it.
class LittleEndian {
 public:
  explicit LittleEndian(std::string_view bytes) : bytes_(bytes) {}

  /// A whole number of so many bytes.
  std::uint64_t number(std::size_t count) {
    const std::string_view digits = take(count);
    std::uint64_t value = 0;
    for (std::size_t i = digits.size(); i-- > 0;) {
      value = 256 * value + static_cast<unsigned char>(digits[i]);
    }
    return value;
  }
  /// Bytes behind their count, a number of so many bytes.
  std::string_view counted(std::size_t count_bytes) {
    return take(static_cast<std::size_t>(number(count_bytes)));
  }
  std::string_view take(std::size_t count) {
    is_short_ = is_short_ || count > bytes_.size();
    if (is_short_) return "";
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  std::string_view rest() const { return bytes_; }
  /// Whether something was asked for that is not there.
  bool is_short() const { return is_short_; }

 private:
  std::string_view bytes_;
  bool is_short_ = false;
};

}  // namespace torquewright::identification
