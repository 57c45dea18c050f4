// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// What the header of an .npy file says (NEP 1): the words that Python writes into it.
struct NpyHeader {
  char kind = 'f';            ///< f: floating, i: integer, u: without sign, b: true or false.
  std::size_t bytes = 0;      ///< Of a number.
  bool is_swapped = false;    ///< Its bytes come greatest first.
  bool is_by_column = false;  ///< "fortran_order".
  std::vector<std::size_t> shape;
  std::string is_no_number;  ///< What its numbers are instead, as "text"; empty for numbers.
};

/// Reads the header's dictionary. `is_no_number` says what cannot be read of it.
NpyHeader npy_header(std::string_view dictionary);

/// Appends the number that stands there, in as few digits as tell it from others of its type.
void append_number(const NpyHeader& header, const char* at, std::string& text);

}  // namespace torquewright::io
