// SPDX-License-Identifier: Apache-2.0
#include "io/text/name_pattern.hpp"

namespace torquewright::io {

bool fits_pattern(std::string_view name, std::string_view pattern) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return name == pattern;
  if (name.substr(0, star) != pattern.substr(0, star)) return false;
  const std::string_view rest = pattern.substr(star + 1);
  for (std::size_t from = star; from <= name.size(); ++from) {
    if (fits_pattern(name.substr(from), rest)) return true;
  }
  return false;
}

}  // namespace torquewright::io
