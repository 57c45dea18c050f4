// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"

namespace torquewright::test {

/// One a line.
inline std::string all_of(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  return text;
}

/// What is said where something is not read; "was read" where it is.
template <typename Read>
std::string refusal(const Read& read) {
  try {
    (void)read();
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "was read";
}

}  // namespace torquewright::test
