// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/faults/spec_error.hpp"

namespace torquewright::io {

/// Objects and lists within one another; deeper text is refused, whatever is to read it.
constexpr std::size_t kMaxDepth = 256;

/// What a JSON text holds. Numbers are finite; one without a fraction is an integer (20.0 is 20).
struct JsonText {
  nlohmann::json root;
  bool complete = false;      ///< False: the text could not be read to its end; root is no use.
  std::vector<Fault> faults;  ///< Syntax (with line and column), duplicate keys, numbers, depth.
};

/// A document as it is written to files: one value a line, a line break at its end. Bytes that are
/// no UTF-8 (the name of a file may hold some) become the replacement character.
std::string json_text(const nlohmann::ordered_json& document, int indent = 1);

/// `/a/b` and the key `c/d` give `/a/b/c~1d` (RFC 6901).
std::string child_path(const std::string& path, std::string_view key);

}  // namespace torquewright::io
