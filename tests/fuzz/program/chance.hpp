// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>

#include "tests/fuzz/mutation.hpp"

namespace torquewright::fuzz {

/// 0 <= index < size. Not a std distribution: those differ between libraries.
inline std::size_t one_below(std::size_t size, Random& random) {
  if (size == 0) throw std::logic_error("nothing to choose from");
  return random() % size;
}

/// True once in so many times.
inline bool once_in(std::size_t count, Random& random) { return one_below(count, random) == 0; }

template <typename List>
const auto& one_of(const List& list, Random& random) {
  return list[one_below(std::size(list), random)];
}

}  // namespace torquewright::fuzz
