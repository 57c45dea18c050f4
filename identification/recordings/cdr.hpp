// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::identification {

/// Reads a message in OMG's common data representation, as ROS 2 writes it: four bytes that say
/// which form it has, then its fields, each at a multiple of its size. What would lie beyond the
/// end is 0 or empty.
class Cdr {
 public:
  explicit Cdr(std::string_view bytes);

  unsigned form() const { return form_; }
  /// Whether the form is read: fields one behind another (XCDR1 and XCDR2, of either byte order).
  bool is_known() const { return form_ <= 1 || form_ == 6 || form_ == 7; }

  std::uint32_t whole_number();
  std::string text();
  void texts(std::vector<std::string>& texts);
  void numbers(std::vector<double>& numbers);

  /// Whether something was asked for that is not there.
  bool is_short() const { return is_short_; }

 private:
  std::string_view take(std::size_t size, std::size_t alignment);
  std::uint64_t number(std::size_t size);
  std::size_t count(std::size_t least_size);

  std::string_view bytes_;
  unsigned form_ = ~0U;
  std::size_t at_ = 0;
  bool is_short_ = false;
};

}  // namespace torquewright::identification
