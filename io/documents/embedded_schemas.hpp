// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace torquewright::io {

/// One file of specs/schema as it was when the library was built.
struct EmbeddedSchema {
  std::string_view kind;
  std::string_view text;
};

/// All of them, by kind in alphabetical order; the build writes the definition.
std::span<const EmbeddedSchema> embedded_schemas();

}  // namespace torquewright::io
