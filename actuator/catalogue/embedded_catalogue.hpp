// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace torquewright::actuator {

/// One file of specs/catalogue as it was when the library was built.
struct EmbeddedDrive {
  std::string_view stem;
  std::string_view text;
};

/// All of them, in the order of their names; the build writes the definition.
std::span<const EmbeddedDrive> embedded_catalogue();

}  // namespace torquewright::actuator
